// The fused groups of fem/kernels/groups.h and fem/dynamics/explicit_steps.h as CUDA kernels, each by a name of its
// own: fused_groups.sh reads what the compiler says of their registers and local memory.
#include <elasticity.physgen.h>
#include <fem/dynamics/explicit_steps.h>
#include <fem/kernels/groups.h>
#include <fem/materials/materials.h>

using namespace physgen;

namespace {

template <class Object, class Real>
using ViewOf = View<Object, Real, Aosoa<32>, FormatsOf<Object, Cuda>, Cuda>;
template <class Object, class Real>
using Padded = View<Object, Real, AosPadded, FormatsOf<Object, Cuda>, Cuda>;

/// The arrays that the groups read and write.
template <class Real>
struct Mesh {
  ViewOf<elasticity::TetObject, const Real> tets;
  ViewOf<elasticity::RestShapeObject, const Real> rest;
  ViewOf<elasticity::TetPlacesObject, const Real> places;
  ViewOf<elasticity::PrincipalDirectionsObject, Real> directions;
  ViewOf<elasticity::StressDerivativeObject, Real> derivatives;
  ViewOf<elasticity::CornerForcesObject, Real> corners;
  ViewOf<elasticity::StressObject, Real> stresses;
  Padded<elasticity::NodePositionObject, const Real> positions;
  Padded<elasticity::NodeDisplacementObject, const Real> displacements;
  Padded<elasticity::NodeForceObject, Real> forces;
  Padded<elasticity::NodeForceDifferentialObject, Real> differentials;
  Padded<elasticity::PlacedForceObject, Real> placed;
};

/// Named in types alone.
template <class Real>
Mesh<Real> mesh();
template <class Model>
Model material();

template <class Real, template <class> class Model = fem::NeoHookean>
struct Groups {
  static auto added_forces() {
    const auto m = mesh<Real>();
    return fem::fuse_added_forces(material<Model<Real>>(), m.tets, m.positions, m.rest, m.forces);
  }
  static auto placed_forces() {
    const auto m = mesh<Real>();
    return fem::fuse_placed_forces(material<Model<Real>>(), m.tets, m.positions, m.rest, m.places, m.placed);
  }
  static auto added_forces_of_displacements() {
    const auto m = mesh<Real>();
    return fem::fuse_added_forces(material<Model<Real>>(), m.tets, m.displacements, m.rest, m.forces);
  }
  static auto placed_forces_of_displacements() {
    const auto m = mesh<Real>();
    return fem::fuse_placed_forces(material<Model<Real>>(), m.tets, m.displacements, m.rest, m.places, m.placed);
  }
  static auto stresses() {
    const auto m = mesh<Real>();
    return fem::fuse_stresses(material<Model<Real>>(), m.tets, m.displacements, m.rest, m.stresses);
  }
  static auto energies() {
    const auto m = mesh<Real>();
    return fem::fuse_energies(material<Model<Real>>(), m.tets, m.displacements, m.rest);
  }
  static auto corner_forces() {
    const auto m = mesh<Real>();
    return fem::fuse_corner_forces(material<Model<Real>>(), m.tets, m.positions, m.rest, m.corners);
  }
  static auto newton_update() {
    const auto m = mesh<Real>();
    return fem::fuse_newton_update(material<Model<Real>>(), m.tets, m.positions, m.rest, m.directions, m.derivatives,
                                   m.corners);
  }
  static auto added_differentials() {
    const auto m = mesh<Real>();
    return fem::fuse_added_differentials(m.tets, m.displacements, m.rest, m.directions, m.derivatives, m.differentials);
  }
};

}  // namespace

// PHYSGEN_KERNEL and PHYSGEN_SUMMAND are undefined below.
#define PHYSGEN_KERNEL(name, group, ...)                                                 \
  extern "C" __global__ void name(const decltype(Groups<__VA_ARGS__>::group()) kernel) { \
    kernel(blockIdx.x * index_t{blockDim.x} + threadIdx.x);                              \
  }
PHYSGEN_KERNEL(added_forces, added_forces, float)
PHYSGEN_KERNEL(added_forces_of_mooney_rivlin, added_forces, float, fem::MooneyRivlin)
PHYSGEN_KERNEL(added_forces_in_double, added_forces, double)
PHYSGEN_KERNEL(placed_forces, placed_forces, float)
PHYSGEN_KERNEL(placed_forces_in_double, placed_forces, double)
PHYSGEN_KERNEL(added_forces_of_displacements, added_forces_of_displacements, float)
PHYSGEN_KERNEL(added_forces_of_displacements_in_double, added_forces_of_displacements, double)
PHYSGEN_KERNEL(placed_forces_of_displacements, placed_forces_of_displacements, float)
PHYSGEN_KERNEL(placed_forces_of_displacements_in_double, placed_forces_of_displacements, double)
PHYSGEN_KERNEL(stresses_of_displacements, stresses, float)
PHYSGEN_KERNEL(stresses_of_displacements_in_double, stresses, double)
PHYSGEN_KERNEL(corner_forces, corner_forces, float)
PHYSGEN_KERNEL(corner_forces_in_double, corner_forces, double)
PHYSGEN_KERNEL(newton_update, newton_update, float)
PHYSGEN_KERNEL(newton_update_in_double, newton_update, double)
PHYSGEN_KERNEL(added_differentials, added_differentials, float)
PHYSGEN_KERNEL(added_differentials_in_double, added_differentials, double)
#undef PHYSGEN_KERNEL

// Groups that give a number for each tet.
#define PHYSGEN_SUMMAND(name, group, real)                                                        \
  extern "C" __global__ void name(const decltype(Groups<real>::group()) kernel, real* summands) { \
    const index_t i = blockIdx.x * index_t{blockDim.x} + threadIdx.x;                             \
    summands[i] = kernel(i);                                                                      \
  }
PHYSGEN_SUMMAND(energies_of_displacements, energies, float)
PHYSGEN_SUMMAND(energies_of_displacements_in_double, energies, double)
#undef PHYSGEN_SUMMAND
