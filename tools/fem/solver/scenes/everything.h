// The scene everything: all that the quasistatic and the implicit solver may be asked for at run time.
#pragma once

#include <fem/materials/stable_neo_hookean.h>
#include <fem/solver/arrays/solver_groups.h>
#include <fem/solver/linear/performed_steps.h>
#include <fem/solver/preconditioners/schwarz/schwarz_group.h>
#include <fem/solver/solvers/solver_program.h>
#include <physgen/scene.h>

namespace scenes {
using namespace physgen::scene;
namespace fem = physgen::fem;

/// Equilibrium and motion of a body with every choice that there is: volumes of tets, patches or nodes; products
/// assembled or by tets; each preconditioner, on meshes and background grids, stored as computed or in half; rigid
/// planes; pressures that follow the surface; and inertia.
struct PHYSGEN_SCENE() everything : fem::groups::OfBody,
                                    fem::groups::OfPatches,
                                    fem::groups::OfRings,
                                    fem::groups::OfChunk,
                                    fem::groups::OfLevel,
                                    fem::groups::OfSchwarz,
                                    fem::groups::OfPlanes,
                                    fem::groups::OfSurface,
                                    fem::groups::OfInertia,
                                    fem::groups::OfKrylov,
                                    fem::groups::OfStresses {
  using Real = fem::groups::Real;

  template <class On, class Body, class Patches, class Rings, class Chunk, class Level, class Schwarz, class Planes,
            class Surface, class Inertia, class Krylov, class Stresses>
  static void program(On& on, Body& body, Patches& patches, Rings& rings, Chunk& chunk, Level& level, Schwarz& schwarz,
                      Planes& planes, Surface& surface, Inertia& inertia, Krylov& krylov, Stresses& stresses,
                      const fem::StableNeoHookean<double>& material, const fem::SolverSettings& settings,
                      fem::MeshFacts& facts, const fem::TimeStep& step) {
    auto solver = fem::solver_program<Real, fem::StoredInHalf, fem::AnyChoice>(
        on, settings, material, facts,
        fem::SolverGroups{body, patches, rings, chunk, level, schwarz, planes, surface, inertia, krylov});
    (void)solver.solve_to(1, {});
    solver.evaluate_stresses(1, stresses.of_tets);
    (void)solver.plane_contacts_of(0);
    (void)solver.step(step);
    (void)solver.motion();
  }
};

}  // namespace scenes
