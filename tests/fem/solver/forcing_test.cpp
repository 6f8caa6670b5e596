// How far Newton's method solves its linear systems: the last step as far as the tolerance asks, and no further.
#include <gtest/gtest.h>

#include <cstdio>

#include "bodies.h"

namespace physgen::fem {
namespace {

/// The steps of a solve in double, each linear solve exact but for what the tolerance allows.
/// @param residual of the forces that it ends with, measured here
std::vector<NewtonStep> steps_to(double tolerance, bool patches, double* residual) {
  const Body body = make_truth_cube_body(8, patches);
  SolverSettings settings = exact_settings("neo-hookean", patches ? 0.49 : 0.45);
  settings.nested = false;
  settings.newton.tolerance = tolerance;
  settings.newton.least_forcing = settings.newton.most_forcing = 1e-11;
  const auto solver = make_solver(body.levels, body.loading, settings);
  std::vector<NewtonStep> steps;
  const NewtonResult result =
      solver->solve_to(0.1, [&](std::size_t /*level*/, const NewtonStep& step) { steps.push_back(step); });
  EXPECT_EQ(result.status, NewtonStatus::converged) << tolerance;
  const auto forces = solver->forces();
  double free = 0, fixed = 0;
  for (std::size_t n = 0; n < forces.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) {
      (body.levels[0].fixed[n] >> k & 1 ? fixed : free) += forces[n][k] * forces[n][k];
    }
  }
  *residual = std::sqrt(free / fixed);
  return steps;
}

TEST(Newton, solves_its_last_step_no_further_than_the_tolerance_asks) {
  for (const bool patches : {false, true}) {
    double residual = 0;
    const auto loose = steps_to(1e-3, patches, &residual), tight = steps_to(1e-9, patches, &residual);
    ASSERT_GE(loose.size(), 2);
    ASSERT_LT(loose.size(), tight.size());
    for (std::size_t k = 0; k + 1 < loose.size(); ++k) EXPECT_GT(tight[k].residual, 1e-3) << "takes no step more";
    const NewtonStep &last = loose.back(), &same = tight[loose.size() - 1];
    std::printf("step %d of the tolerance 1e-3: %d iterations, residual %.1e; of 1e-9: %d, %.1e\n", last.number,
                last.iterations, last.residual, same.iterations, same.residual);
    EXPECT_LE(2 * last.iterations, same.iterations);
  }
}

TEST(Newton, ends_with_forces_within_the_tolerance_though_its_last_step_is_solved_no_further) {
  for (const bool patches : {false, true}) {
    for (const double tolerance : {1e-2, 1e-3, 1e-5, 1e-7, 1e-9}) {
      double residual = 0;
      const auto steps = steps_to(tolerance, patches, &residual);
      EXPECT_LE(residual, tolerance);
      EXPECT_NEAR(residual, steps.back().residual, 1e-6 * residual + 1e-14);
      EXPECT_LE(steps.size(), 6) << tolerance;
      std::printf("tolerance %.0e: %zu steps, residual %.1e\n", tolerance, steps.size(), residual);
    }
  }
}

}  // namespace
}  // namespace physgen::fem
