// The scene quasistatic_fixed_corotated: equilibrium of a body by Newton's method with an assembled tangent, in a
// material whose volumes are those of its tets.
#pragma once

#include <fem/materials/fixed_corotated.h>
#include <fem/solver/arrays/solver_groups.h>
#include <fem/solver/linear/performed_steps.h>
#include <fem/solver/solvers/solver_program.h>
#include <physgen/scene.h>

namespace scenes {
using namespace physgen::scene;
namespace fem = physgen::fem;

/// Equilibrium of a fixed corotated body, tet by tet: Newton's method, conjugate gradients with an assembled stiffness,
/// and multigrid on meshes that halve each other's cells.
struct PHYSGEN_SCENE() quasistatic_fixed_corotated : fem::groups::OfBody,
                                                     fem::groups::OfChunk,
                                                     fem::groups::OfLevel,
                                                     fem::groups::OfKrylov,
                                                     fem::groups::OfStresses {
  using Real = fem::groups::Real;

  template <class On, class Body, class Chunk, class Level, class Krylov, class Stresses>
  static void program(On& on, Body& body, Chunk& chunk, Level& level, Krylov& krylov, Stresses& stresses,
                      const fem::FixedCorotated<double>& material, const fem::SolverSettings& settings,
                      fem::MeshFacts& facts) {
    fem::NoArrays none;
    auto solver = fem::solver_program<Real, fem::StoredAsComputed, fem::AssembledOnMeshes>(
        on, settings, material, facts,
        fem::SolverGroups{body, none, none, chunk, level, none, none, none, none, krylov});
    (void)solver.solve_to(1, {});
    solver.evaluate_stresses(1, stresses.of_tets);
  }
};

}  // namespace scenes
