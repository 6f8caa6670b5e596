// The scene linear_elastic: an equilibrium for small strain.
#pragma once

#include <fem/solver/arrays/solver_groups.h>
#include <fem/solver/newton/linear_steps.h>
#include <physgen/scene.h>

namespace scenes {
using namespace physgen::scene;
namespace fem = physgen::fem;

/// Linear elasticity: an equilibrium by conjugate gradients without blocks of edges, preconditioned by the inverses of
/// nodes' blocks.
struct PHYSGEN_SCENE() linear_elastic : fem::groups::OfLinear,
                                        fem::groups::OfLevel,
                                        fem::groups::OfKrylov,
                                        fem::groups::OfStresses {
  using Real = fem::groups::Real;

  template <class On, class Linear, class Level, class Krylov, class Stresses>
  static void program(On& on, Linear& linear, Level& level, Krylov& krylov, Stresses& stresses,
                      const fem::LameParameters& lame, double load, double tolerance, int most_iterations) {
    using namespace fem;
    begin_linear(on, linear, level, lame, load);
    prepare_linear_nodes(on, linear, level, lame);
    typename On::Loop loop;
    solve_linear_matrix_free(on, loop, linear, level, krylov, lame, true, tolerance, most_iterations);
    evaluate_linear(on, linear, level, lame, load);
    measure_smallest_ratio(on, linear);
    compute_linear_stresses(on, linear, lame, stresses.of_tets);
  }
};

}  // namespace scenes
