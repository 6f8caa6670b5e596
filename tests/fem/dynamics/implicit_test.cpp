// Backward Euler on Newton's method against motions that it is known to give, and its limits: quasistatic equilibrium
// for long steps, the explicit scheme for short ones.
#include <fem/dynamics/explicit.h>
#include <fem/solver/hierarchy/background_grid.h>
#include <gtest/gtest.h>
#include <physgen/error.h>

#include "moving.h"

namespace physgen::fem {
namespace {

/// A step of a body of irregular cells, that is held nowhere, is solved for on its mesh alone.
DynamicSettings implicit_settings(const std::string& material, double youngs_modulus, double poissons_ratio) {
  DynamicSettings settings = moving_settings(material, youngs_modulus, poissons_ratio);
  settings.solver.newton.preconditioner.kind = Preconditioner::block_jacobi;
  return settings;
}

TEST(ImplicitDynamics, a_body_falls_as_backward_euler_makes_a_point_fall) {
  const Body body = falling_body(3, side);
  for (const TangentPrecision precision : {TangentPrecision::float64, TangentPrecision::half}) {
    DynamicSettings settings = implicit_settings("neo-hookean", 1e4, 0.45);
    settings.solver.precision = precision;
    settings.solver.newton.tolerance = 1e-8;
    const auto solver = make_implicit_solver(body.levels, body.loading, settings);
    constexpr double dt = 0.01;
    constexpr int steps = 20;
    for (int k = 0; k < steps; ++k) ASSERT_EQ(solver->step(dt, 1).status, NewtonStatus::converged);
    EXPECT_NEAR(solver->time(), steps * dt, 1e-12);
    const double fallen = dt * dt * steps * (steps + 1) / 2, speed = steps * dt;
    const auto x = solver->positions(), v = solver->velocities();
    for (std::size_t n = 0; n < x.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(x[n][k] - body.levels[0].rest[n][k], gravity[k] * fallen, 1e-7 * fallen);
        EXPECT_NEAR(v[n][k], gravity[k] * speed, 1e-6 * speed);
      }
    }
  }
}

TEST(ImplicitDynamics, damping_slows_a_falling_body_as_it_slows_a_point) {
  const Body body = falling_body(2, side);
  DynamicSettings settings = implicit_settings("fixed-corotated", 1e4, 0.3);
  settings.damping = 3;
  const auto solver = make_implicit_solver(body.levels, body.loading, settings);
  constexpr double dt = 0.05;
  Point v{};
  for (int step = 0; step < 10; ++step) {
    ASSERT_EQ(solver->step(dt, 1).status, NewtonStatus::converged);
    for (std::size_t k = 0; k < 3; ++k) v[k] = (v[k] + dt * gravity[k]) / (1 + dt * settings.damping);
  }
  ASSERT_LT(std::abs(v[2]), 0.7 * 10 * dt * 9.81);  // it matters
  for (const Point& found : solver->velocities()) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], v[k], 1e-8 * std::abs(v[k]));
  }
}

/// The mode of a bar against a function of the step, over a number of steps: the largest difference.
template <class Expected>
double mode_difference(const WaveBar& bar, double dt, int steps, const Expected& expected) {
  const auto solver = make_implicit_solver(bar.body.levels, bar.body.loading,
                                           moving_settings("neo-hookean", WaveBar::young, WaveBar::nu));
  bar.begin(*solver);
  double largest = 0;
  for (int k = 1; k <= steps; ++k) {
    EXPECT_EQ(solver->step(dt, 1).status, NewtonStatus::converged);
    largest = std::max(largest, std::abs(bar.part(*solver) - expected(k)));
  }
  return largest;
}

TEST(ImplicitDynamics, a_bar_swings_as_a_chain_with_the_damping_of_backward_euler) {
  const WaveBar bar(4);
  for (const double angle : {0.05, 0.5, 5.0}) {  // omega dt
    const double dt = angle / bar.frequency();
    // Each step divides the mode, with velocity as its imaginary part, by 1 + i omega dt.
    const std::complex<double> factor = 1.0 / std::complex<double>(1, angle);
    EXPECT_LE(mode_difference(bar, dt, 40, [&](int k) { return std::pow(factor, k).real(); }), 1e-5) << angle;
  }
}

TEST(ImplicitDynamics, errors_halve_with_the_time_step) {
  const WaveBar bar(4);
  const auto error = [&](int steps) {
    const double dt = std::numbers::pi / bar.frequency() / steps;  // half a period
    return mode_difference(bar, dt, steps, [&](int k) { return std::cos(bar.frequency() * k * dt); });
  };
  const double coarse = error(60), fine = error(120), finest = error(240);
  EXPECT_NEAR(coarse / fine, 2, 0.1);
  EXPECT_NEAR(fine / finest, 2, 0.05);
}

TEST(ImplicitDynamics, momentum_is_kept_without_loads_and_energy_falls) {
  const Body body = free_body(3, side);
  const auto& rest = body.levels[0].rest;
  DynamicSettings settings = implicit_settings("neo-hookean", 1e4, 0.4);
  settings.solver.newton.tolerance = 1e-10;
  const auto solver = make_implicit_solver(body.levels, body.loading, settings);
  solver->set_positions(sum(rest, random_vectors(rest.size(), 0.1 * side / 3, 5)));
  solver->set_velocities(random_vectors(rest.size(), 0.3, 6));
  const MotionMeasure before = solver->measure();
  double energy = before.kinetic + before.elastic, mass = 0;
  for (const double own : lumped_masses(body.levels[0].mesh, rest, density)) mass += own;
  for (int k = 0; k < 20; ++k) {
    ASSERT_EQ(solver->step(2e-3, 1).status, NewtonStatus::converged);
    const MotionMeasure now = solver->measure();
    EXPECT_LT(now.kinetic + now.elastic, energy);
    energy = now.kinetic + now.elastic;
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(now.momentum[c], before.momentum[c], 1e-9 * mass * 0.3);
  }
  EXPECT_LT(energy, 0.5 * (before.kinetic + before.elastic));
}

TEST(ImplicitDynamics, a_body_that_is_turned_and_moved_stays_where_it_is) {
  const Body body = free_body(3, side);
  std::vector<Point> turned = body.levels[0].rest;
  for (Point& x : turned) x = {0.6 * x[0] - 0.8 * x[1] + 0.3, 0.8 * x[0] + 0.6 * x[1], x[2] - 0.1};
  const auto solver = make_implicit_solver(body.levels, body.loading, implicit_settings("neo-hookean", 1e4, 0.4));
  solver->set_positions(turned);
  for (int k = 0; k < 10; ++k) ASSERT_EQ(solver->step(0.01, 1).status, NewtonStatus::converged);
  EXPECT_LE(largest_distance(solver->positions(), turned), 1e-12);
}

TEST(ImplicitDynamics, one_long_step_leads_to_the_quasistatic_equilibrium) {
  for (const Volume volume : volumes) {
    for (const Preconditioner kind : {Preconditioner::multigrid, Preconditioner::schwarz}) {
      const Body body = with_contact(with(volume, make_truth_cube_body(4, volume == Volume::patches)));
      DynamicSettings settings = moving_settings("neo-hookean", 1e4, 0.45);
      settings.solver.newton.tolerance = 1e-10;
      settings.solver.newton.preconditioner.kind = kind;
      const auto dynamic = make_implicit_solver(body.levels, body.loading, settings);
      const auto quasistatic = make_solver(body.levels, body.loading, settings.solver);
      ASSERT_EQ(dynamic->step(1e6, 0.1).status, NewtonStatus::converged);
      ASSERT_EQ(quasistatic->solve_to(0.1, {}).status, NewtonStatus::converged);
      EXPECT_LE(largest_distance(dynamic->positions(), quasistatic->positions()), 1e-8 * side) << name_of(volume);
      EXPECT_LE(largest_distance(dynamic->forces(), quasistatic->forces()), 1e-7 * 1e4 * side * side);
      EXPECT_LE(dynamic->measure().kinetic, 1e-12);
    }
  }
}

/// Positions in a cube whose upper plate begins to move, by either scheme, after the same time.
std::vector<Point> moved_by_plate(bool is_explicit, double dt, int steps) {
  const Body body = make_truth_cube_body(4, false);
  DynamicSettings settings = moving_settings("neo-hookean", 1e4, 0.3);
  settings.damping = 5;
  const auto solver = is_explicit ? make_explicit_solver(body.levels[0], body.loading, settings)
                                  : make_implicit_solver(body.levels, body.loading, settings);
  for (int k = 1; k <= steps; ++k) {
    const double part = double(k) / steps;
    EXPECT_EQ(solver->step(dt, 0.05 * part * part).status, NewtonStatus::converged);
  }
  EXPECT_LT(solver->measure().momentum[2], -1e-4);  // it moves
  return solver->positions();
}

TEST(ImplicitDynamics, explicit_and_implicit_motion_meet_as_steps_become_short) {
  constexpr double time = 0.02;
  const auto difference = [&](int steps) {
    return largest_distance(moved_by_plate(true, time / steps, steps), moved_by_plate(false, time / steps, steps));
  };
  const double coarse = difference(100), fine = difference(200);
  EXPECT_LT(coarse, 1e-3 * side);
  EXPECT_NEAR(coarse / fine, 2, 0.3);
}

TEST(ImplicitDynamics, multigrid_takes_no_more_iterations_than_without_inertia) {
  for (const bool nested : {true, false}) {  // levels of the cube, or a background grid
    Body body = make_truth_cube_body(8, true);
    if (!nested) {
      body.levels.resize(1);
      body.levels[0].parents.clear();
      body.levels[0].patch_parents.clear();
      (void)add_background_grid(body.levels);
    }
    const auto iterations_of_step = [&](double dt) {
      DynamicSettings settings = moving_settings("neo-hookean", 1e4, 0.45);
      settings.solver.newton.least_forcing = settings.solver.newton.most_forcing = 1e-6;
      const auto solver = make_implicit_solver(body.levels, body.loading, settings);
      const NewtonResult result = solver->step(dt, 0.05);
      EXPECT_EQ(result.status, NewtonStatus::converged);
      return double(result.iterations) / result.steps;
    };
    const double without = iterations_of_step(1e6);
    for (const double dt : {1e-1, 1e-2, 3e-3, 1e-3, 1e-4}) {
      EXPECT_LE(iterations_of_step(dt), without + 2) << nested << " " << dt;
    }
  }
}

TEST(ImplicitDynamics, a_body_that_nothing_holds_is_preconditioned_by_its_levels) {
  Body body =
      make_cube(8, side, true, 0, [](const Point&) { return std::uint8_t{0}; }, [](const Point&) { return Point{}; });
  const auto& rest = body.levels[0].rest;
  for (const bool grid : {false, true}) {
    if (grid) {
      body.levels.resize(1);
      body.levels[0].parents.clear();
      body.levels[0].patch_parents.clear();
      (void)add_background_grid(body.levels);
    }
    for (const double dt : {3e-3, 3e-2}) {
      const auto solver = make_implicit_solver(body.levels, body.loading, moving_settings("neo-hookean", 1e4, 0.45));
      solver->set_velocities(random_vectors(rest.size(), 0.1, 6));
      const NewtonResult result = solver->step(dt, 0);
      EXPECT_EQ(result.status, NewtonStatus::converged);
      EXPECT_LE(result.iterations, 15 * result.steps) << grid << " " << dt;
    }
  }
}

TEST(ImplicitDynamics, a_step_that_fails_leaves_the_motion_as_it_was) {
  const Body body = make_truth_cube_body(4, true);
  DynamicSettings settings = moving_settings("neo-hookean", 1e4, 0.45);
  settings.solver.newton.most_steps = 2;
  settings.solver.newton.tolerance = 1e-4;
  const auto solver = make_implicit_solver(body.levels, body.loading, settings);
  ASSERT_EQ(solver->step(1e-3, 1e-5).status, NewtonStatus::converged);
  const auto x = solver->positions(), v = solver->velocities();
  ASSERT_EQ(solver->step(1, 0.4).status, NewtonStatus::too_many_steps);
  EXPECT_EQ(solver->positions(), x);
  EXPECT_EQ(solver->velocities(), v);
  EXPECT_EQ(solver->time(), 1e-3);
}

TEST(ImplicitDynamics, what_it_cannot_do_is_refused_with_a_reason) {
  const auto refusal = [](const DynamicSettings& settings) -> std::string {
    const Body body = make_truth_cube_body(2, false);
    try {
      (void)make_implicit_solver(body.levels, body.loading, settings);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const DynamicSettings good = moving_settings("neo-hookean", 1e4, 0.3);
  EXPECT_EQ(refusal(good), "");
  DynamicSettings settings = good;
  settings.density = -3;
  EXPECT_NE(refusal(settings).find("the density is -3 "), std::string::npos);
  settings = good;
  settings.solver.newton.product = Product::matrix_free;
  settings.solver.newton.preconditioner.kind = Preconditioner::block_jacobi;
  EXPECT_NE(refusal(settings).find("inertia requires the assembled product"), std::string::npos);
}

TEST(ImplicitDynamics, positions_and_velocities_that_are_not_finite_are_refused_and_change_nothing) {
  const Body body = make_truth_cube_body(2, false);
  expect_only_finite_vectors(
      *make_implicit_solver(body.levels, body.loading, moving_settings("neo-hookean", 1e4, 0.3)));
}

}  // namespace
}  // namespace physgen::fem
