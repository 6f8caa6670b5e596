// Explicit dynamics as a program over an executor and arrays by name: symplectic Euler with lumped mass. The forces at
// the displacements that are known give new velocities, and these give new displacements.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <elasticity.physgen.h>
#include <fem/kernels/groups.h>
#include <fem/numerics/scalar.h>
#include <fem/solver/loads/time_step.h>
#include <physgen/launch/reduce.h>
#include <physgen/memory/space.h>
#include <physgen/rows.h>
#ifdef __CUDACC__
#include <physgen/cuda/parallel_for.h>
#endif

namespace physgen::fem {

/// v += dt f / m and u += dt v in free components, f being elastic and external forces; damping is taken at the new
/// velocity, so that any is stable. Prescribed components go where the load takes them, at the velocity that leads
/// there.
template <class ForceView, class LoadView, class MassView, class ConstraintView, class MotionView, class VelocityView,
          class DisplacementView, class RoundedView>
struct MoveNodes {
  using Scalar = double;
  TimeStep step;
  ForceView forces;                ///< elasticity::NodeForce: of the tets
  LoadView loads;                  ///< elasticity::NodeForce: external, at a load of 1
  MassView masses;                 ///< dynamics::NodeMass
  ConstraintView constraints;      ///< quasistatic::NodeConstraint
  MotionView motion;               ///< elasticity::NodeDisplacement: of prescribed components, at a load of 1
  VelocityView velocities;         ///< dynamics::NodeVelocity
  DisplacementView displacements;  ///< elasticity::NodeDisplacement: u, from rest
  RoundedView rounded;             ///< elasticity::NodeDisplacement: u in the precision of tets, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Vector = Eigen::Matrix<double, 3, 1>;
    using Real = typename RoundedView::Precision;
    const int fixed = constraints[node].fixed();
    const double mass = masses[node].mass();
    const Vector external = loads[node].f(), path = motion[node].dx();
    Vector v = velocities[node].v(), u = displacements[node].dx();
    for (int k = 0; k < 3; ++k) {
      if ((fixed >> k & 1) != 0) {
        const double target = path[k] * step.load;
        v[k] = (target - u[k]) / step.length;
        u[k] = target;
      } else if (mass > 0) {
        const double force = double(forces[node].f()[k]) + external[k] * step.load;
        v[k] = (v[k] + step.length * (force / mass)) / (1 + step.length * step.damping);
        u[k] += step.length * v[k];
      }
    }
    velocities[node].v() = v;
    displacements[node].dx() = u;
    for (int k = 0; k < 3; ++k) rounded[node].dx()[k] = static_cast<Real>(u[k]);
  }
};

/// Elastic energy of a tet [J].
template <class Material, class RestView, class SvdView>
struct StretchEnergy {
  using Scalar = typename SvdView::Precision;
  Material material;      ///< in Scalar
  RestView rest;          ///< elasticity::RestShape
  SvdView decomposition;  ///< elasticity::DeformationSvd, of which s is read

  template <class I>
  PHYSGEN_FUNCTION auto operator()(I i) const -> lanes_t<Scalar, I> {
    using S = lanes_t<Scalar, I>;
    const Vector3<S> s = decomposition[i].s();
    return S(rest[i].volume()) * material.energy(s);
  }
};

template <class MotionView>
struct StoreElastic {
  MotionView motion;  ///< dynamics::Motion
  PHYSGEN_FUNCTION void operator()(double energy) const { motion[index_t{0}].elastic() = energy; }
};

/// From displacements to first Piola-Kirchhoff stresses.
/// @param tets elasticity::Tet @param displacements elasticity::NodeDisplacement @param rest elasticity::RestShape
/// @param stresses elasticity::Stress, written
template <class Material, class TetView, class DisplacementView, class RestView, class StressView>
[[nodiscard]] auto fuse_stresses(const Material& material, const TetView& tets, const DisplacementView& displacements,
                                 const RestView& rest, const StressView& stresses) {
  using Real = typename RestView::Precision;
  constexpr auto F = local<elasticity::DeformationGradientObject, Real>();
  constexpr auto svd = local<elasticity::DeformationSvdObject, Real>();
  return fuse(locals(F, svd), gradient_step(tets, displacements, rest, F), ComputeSvd{F, svd},
              ComputeStress{material, svd, stresses});
}

/// From displacements to the elastic energies of tets [J], which the last step gives.
template <class Material, class TetView, class DisplacementView, class RestView>
[[nodiscard]] auto fuse_energies(const Material& material, const TetView& tets, const DisplacementView& displacements,
                                 const RestView& rest) {
  using Real = typename RestView::Precision;
  constexpr auto F = local<elasticity::DeformationGradientObject, Real>();
  constexpr auto svd = local<elasticity::DeformationSvdObject, Real>();
  return fuse(locals(F, svd), gradient_step(tets, displacements, rest, F), ComputeSvd{F, svd},
              StretchEnergy{material, rest, svd});
}

/// First Piola-Kirchhoff stress of all tets.
/// @param body arrays by the names of the scene explicit_dynamics
/// @param stresses an array of elasticity::Stress, one per tet
template <class On, class Body, class Material, class Stresses>
void compute_stresses(On& on, Body& body, const Material& material, Stresses& stresses) {
  on.run(body.tets.size(), fuse_stresses(material, body.tets.const_view(), body.rounded.const_view(),
                                         body.rest.const_view(), stresses.view()));
}

/// Elastic forces on all nodes: what the tets' kernels hand on to each other is in no array. On the CPU nodes gather
/// corner forces; on CUDA tets add to nodes, or, where the body has room for placed forces, store in the nodes' rows
/// what is then summed, with the same bits on every run.
template <class On, class Body, class Material>
void compute_forces(On& on, Body& body, const Material& material) {
  const index_t tet_count = body.tets.size(), nodes = body.velocities.size();
  const auto tets = body.tets.const_view();
  const auto displacements = body.rounded.const_view();
  const auto rest = body.rest.const_view();
  const auto forces = body.forces.view();
  if constexpr (RunsIn<On, Cuda>) {
    if (body.placed.size() > 0) {
      on.run(tet_count,
             fuse_placed_forces(material, tets, displacements, rest, body.places.const_view(), body.placed.view()));
      const SumRowForces sum{body.node_tet_ranges.const_view(), body.placed.const_view(), forces};
      on.perform([&](Stream stream) { parallel_for(Cuda{}, sum.size(), sum, stream); });  // four threads for each node
    } else {
      on.run(nodes, ClearNodes{forces});
      on.run(tet_count, fuse_added_forces(material, tets, displacements, rest, forces));
    }
  } else {
    on.run(tet_count, fuse_corner_forces(material, tets, displacements, rest, body.corners.view()));
    on.run(nodes, GatherForces{Rows(body.node_tet_ranges.const_view(), body.node_tets.const_view(), tet_count),
                               body.corners.const_view(), forces});
  }
}

/// Leaves the energies and the momentum of a body in body.measured.
template <class On, class Body, class Material>
void measure_explicit_motion(On& on, Body& body, const Material& material) {
  on.reduce(body.velocities.size(), NodeMotion{body.masses.const_view(), body.velocities.const_view()}, Sum{},
            StoreMotion{body.measured.view()});
  on.reduce(body.tets.size(),
            fuse_energies(material, body.tets.const_view(), body.rounded.const_view(), body.rest.const_view()), Sum{},
            StoreElastic{body.measured.view()});
}

/// One time step.
/// @param material in the precision of the tets' arrays
template <class On, class Body, class Material>
void explicit_step(On& on, Body& body, const Material& material, const TimeStep& step) {
  compute_forces(on, body, material);
  on.run(body.velocities.size(),
         MoveNodes{step, body.forces.const_view(), body.loads.const_view(), body.masses.const_view(),
                   body.constraints.const_view(), body.motion.const_view(), body.velocities.view(),
                   body.displacements.view(), body.rounded.view()});
}

}  // namespace physgen::fem

#pragma pop_macro("I")
