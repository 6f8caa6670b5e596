// The scene quasistatic: equilibrium of a body by Newton's method with an assembled tangent, volumes averaged over
// patches.
#pragma once

#include <fem/materials/stable_neo_hookean.h>
#include <fem/solver/arrays/solver_groups.h>
#include <fem/solver/linear/performed_steps.h>
#include <fem/solver/solvers/solver_program.h>
#include <physgen/scene.h>

namespace scenes {
using namespace physgen::scene;
namespace fem = physgen::fem;

/// Equilibrium of a stable Neo-Hookean body: Newton's method, conjugate gradients with an assembled stiffness, and
/// multigrid on meshes that halve each other's cells. Volumes are averaged over patches of tets.
struct PHYSGEN_SCENE() quasistatic : fem::groups::OfBody,
                                     fem::groups::OfPatches,
                                     fem::groups::OfChunk,
                                     fem::groups::OfLevel,
                                     fem::groups::OfKrylov,
                                     fem::groups::OfStresses {
  using Real = fem::groups::Real;

  template <class On, class Body, class Patches, class Chunk, class Level, class Krylov, class Stresses>
  static void program(On& on, Body& body, Patches& patches, Chunk& chunk, Level& level, Krylov& krylov,
                      Stresses& stresses, const fem::StableNeoHookean<double>& material,
                      const fem::SolverSettings& settings, fem::MeshFacts& facts) {
    fem::NoArrays none;
    auto solver = fem::solver_program<Real, fem::StoredAsComputed, fem::AssembledOnMeshes>(
        on, settings, material, facts,
        fem::SolverGroups{body, patches, none, chunk, level, none, none, none, none, krylov});
    (void)solver.solve_to(1, {});
    solver.evaluate_stresses(1, stresses.of_tets);
  }
};

}  // namespace scenes
