// The scene linear_elastic_assembled: an equilibrium for small strain with assembled stiffness and each of its
// preconditioners.
#pragma once

#include <fem/solver/arrays/solver_groups.h>
#include <fem/solver/linear/performed_steps.h>
#include <fem/solver/newton/linear_steps.h>
#include <fem/solver/preconditioners/extra_arrays.h>
#include <fem/solver/preconditioners/schwarz/schwarz_group.h>
#include <physgen/scene.h>

#include <memory>
#include <utility>
#include <vector>

namespace scenes {
using namespace physgen::scene;
namespace fem = physgen::fem;

/// Linear elasticity: an equilibrium by conjugate gradients with assembled stiffness, and each preconditioner that
/// there is for it, on meshes and background grids, stored as computed or in half.
struct PHYSGEN_SCENE() linear_elastic_assembled : fem::groups::OfLinear,
                                                  fem::groups::OfLevel,
                                                  fem::groups::OfSchwarz,
                                                  fem::groups::OfKrylov,
                                                  fem::groups::OfStresses {
  using Real = fem::groups::Real;

  template <class On, class Linear, class Level, class Schwarz, class Krylov, class Stresses>
  static void program(On& on, Linear& linear, Level& level, Schwarz& schwarz, Krylov& krylov, Stresses& stresses,
                      const fem::NewtonSettings& settings, const fem::LameParameters& lame, double load) {
    using namespace fem;
    using Over = LevelOver<Real, typename On::Space, StoredInHalf, AssembledAnywhere, Level, ExtraOver<Schwarz>,
                           NoArrays, NoArrays>;
    std::vector<std::unique_ptr<Over>> levels;
    levels.push_back(std::make_unique<Over>(std::move(level)));
    levels[0]->extra = std::make_unique<ExtraOver<Schwarz>>(std::move(schwarz));
    typename On::Loop loop;
    begin_linear(on, linear, *levels[0], lame, load);
    prepare_linear(on, linear, levels, lame, settings.preconditioner);
    solve_linear(on, loop, linear, levels, krylov, settings, settings.tolerance);
    evaluate_linear(on, linear, *levels[0], lame, load);
    measure_smallest_ratio(on, linear);
    compute_linear_stresses(on, linear, lame, stresses.of_tets);
  }
};

}  // namespace scenes
