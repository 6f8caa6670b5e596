// The scene implicit_dynamics: a time step of backward Euler by Newton's method with an assembled tangent, volumes
// averaged over patches.
#pragma once

#include <fem/materials/stable_neo_hookean.h>
#include <fem/solver/arrays/solver_groups.h>
#include <fem/solver/linear/performed_steps.h>
#include <fem/solver/solvers/solver_program.h>
#include <physgen/scene.h>

namespace scenes {
using namespace physgen::scene;
namespace fem = physgen::fem;

/// Motion of a stable Neo-Hookean body: one step of backward Euler with lumped mass and damping, whose equilibrium is
/// found as that of the scene quasistatic. Volumes are averaged over patches of tets.
struct PHYSGEN_SCENE() implicit_dynamics : fem::groups::OfBody,
                                           fem::groups::OfPatches,
                                           fem::groups::OfChunk,
                                           fem::groups::OfLevel,
                                           fem::groups::OfInertia,
                                           fem::groups::OfKrylov {
  using Real = fem::groups::Real;

  /// Leaves momentum and kinetic energy in inertia.measured.
  /// @return how the step was solved for; where it did not converge, positions and velocities are as before
  template <class On, class Body, class Patches, class Chunk, class Level, class Inertia, class Krylov>
  static fem::NewtonResult program(On& on, Body& body, Patches& patches, Chunk& chunk, Level& level, Inertia& inertia,
                                   Krylov& krylov, const fem::StableNeoHookean<double>& material,
                                   const fem::SolverSettings& settings, fem::MeshFacts& facts,
                                   const fem::TimeStep& step) {
    fem::NoArrays none;
    auto solver = fem::solver_program<Real, fem::StoredAsComputed, fem::AssembledOnMeshes>(
        on, settings, material, facts,
        fem::SolverGroups{body, patches, none, chunk, level, none, none, none, inertia, krylov});
    const fem::NewtonResult result = solver.step(step);
    (void)solver.motion();
    return result;
  }
};

}  // namespace scenes
