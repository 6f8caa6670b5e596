// Explicit dynamics against motions that symplectic Euler is known to give, to rounding, and its properties.
#include <fem/dynamics/explicit.h>
#include <gtest/gtest.h>
#include <physgen/error.h>

#include "highest_frequency.h"
#include "moving.h"

namespace physgen::fem {
namespace {

/// The precisions tets are computed in, and what is left of a result.
constexpr std::array precisions{std::pair{TangentPrecision::float64, 1e-11},
                                std::pair{TangentPrecision::float32, 1e-4}};

TEST(ExplicitDynamics, a_body_falls_as_symplectic_euler_makes_a_point_fall) {
  const Body body = falling_body(3, side);
  for (const auto& [precision, tolerance] : precisions) {
    DynamicSettings settings = moving_settings("neo-hookean", 1e4, 0.45);
    settings.solver.precision = precision;
    const auto solver = make_explicit_solver(body.levels[0], body.loading, settings);
    const double dt = 0.5 * stable_time_step(body.levels[0], settings);
    constexpr int steps = 50;
    for (int k = 0; k < steps; ++k) ASSERT_EQ(solver->step(dt, 1).status, NewtonStatus::converged);
    EXPECT_NEAR(solver->time(), steps * dt, 1e-12 * steps * dt);
    const double fallen = dt * dt * steps * (steps + 1) / 2, speed = steps * dt;
    const auto x = solver->positions(), v = solver->velocities();
    for (std::size_t n = 0; n < x.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(x[n][k] - body.levels[0].rest[n][k], gravity[k] * fallen, tolerance * fallen * 10);
        EXPECT_NEAR(v[n][k], gravity[k] * speed, tolerance * speed * 10);
      }
    }
  }
}

TEST(ExplicitDynamics, damping_slows_a_falling_body_as_it_slows_a_point) {
  const Body body = falling_body(2, side);
  DynamicSettings settings = moving_settings("fixed-corotated", 1e4, 0.3);
  settings.damping = 700;
  const auto solver = make_explicit_solver(body.levels[0], body.loading, settings);
  const double dt = 0.5 * stable_time_step(body.levels[0], settings);
  Point v{};
  for (int step = 0; step < 20; ++step) {
    (void)solver->step(dt, 1);
    for (std::size_t k = 0; k < 3; ++k) v[k] = (v[k] + dt * gravity[k]) / (1 + dt * settings.damping);
  }
  ASSERT_LT(std::abs(v[2]), 0.7 * 20 * dt * 9.81);  // it matters
  for (const Point& found : solver->velocities()) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], v[k], 1e-10 * std::abs(v[k]));
  }
}

TEST(ExplicitDynamics, momentum_and_angular_momentum_are_kept_without_loads) {
  const Body body = free_body(3, side);
  const auto& rest = body.levels[0].rest;
  const auto masses = lumped_masses(body.levels[0].mesh, rest, density);
  for (const std::string& material : material_names()) {
    const DynamicSettings settings = moving_settings(material, 1e4, 0.4);
    const auto solver = make_explicit_solver(body.levels[0], body.loading, settings);
    solver->set_positions(sum(rest, random_vectors(rest.size(), 0.1 * side / 3, 5)));
    solver->set_velocities(random_vectors(rest.size(), 0.3, 6));
    const Momenta before = momenta(*solver, masses);
    const double kinetic_before = solver->measure().kinetic;
    const double dt = 0.4 * stable_time_step(body.levels[0], settings);
    for (int k = 0; k < 100; ++k) (void)solver->step(dt, 1);
    const Momenta after = momenta(*solver, masses);
    const MotionMeasure measure = solver->measure();
    ASSERT_TRUE(measure.is_finite()) << material;
    EXPECT_GT(std::abs(measure.kinetic / kinetic_before - 1), 0.01) << material;  // it swings
    double scale = 0;
    for (const double mass : masses) scale += 0.3 * mass;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(after.linear[k], before.linear[k], 1e-12 * scale) << material;
      EXPECT_NEAR(measure.momentum[k], after.linear[k], 1e-12 * scale) << material;
      EXPECT_NEAR(after.angular[k], before.angular[k], 1e-12 * scale * side) << material;
    }
  }
}

TEST(ExplicitDynamics, a_body_that_is_turned_and_moved_stays_where_it_is) {
  const Body body = free_body(3, side);
  std::vector<Point> turned = body.levels[0].rest;
  for (Point& x : turned) x = {0.6 * x[0] - 0.8 * x[1] + 0.3, 0.8 * x[0] + 0.6 * x[1], x[2] - 0.1};
  for (const std::string& material : material_names()) {
    const DynamicSettings settings = moving_settings(material, 1e4, 0.4);
    const auto solver = make_explicit_solver(body.levels[0], body.loading, settings);
    solver->set_positions(turned);
    const double dt = 0.4 * stable_time_step(body.levels[0], settings);
    for (int k = 0; k < 50; ++k) (void)solver->step(dt, 1);
    EXPECT_LE(largest_distance(solver->positions(), turned), 1e-12) << material;
  }
}

TEST(ExplicitDynamics, a_bar_swings_as_a_chain_of_masses) {
  const WaveBar bar(4);
  EXPECT_NEAR(bar.frequency() / WaveBar::exact_frequency(), 1, 0.03);  // second order in the length of a cell
  EXPECT_NEAR(WaveBar(8).frequency() / WaveBar::exact_frequency(), 1, 0.03 / 4);
  for (const std::string& material : material_names()) {
    const DynamicSettings settings = moving_settings(material, WaveBar::young, WaveBar::nu);
    const auto solver = make_explicit_solver(bar.body.levels[0], bar.body.loading, settings);
    bar.begin(*solver);
    const double dt = 0.9 * stable_time_step(bar.body.levels[0], settings), bend = std::pow(bar.frequency() * dt, 2);
    double now = 1, change = 0;  // of the mode
    for (int k = 0; k < 60; ++k) {
      (void)solver->step(dt, 1);
      change -= bend * now;
      now += change;
      ASSERT_NEAR(bar.part(*solver), now, 1e-5) << material << " " << k;
    }
  }
}

/// The largest error of the mode over two periods.
double mode_error(int steps_of_period) {
  const WaveBar bar(4);
  const DynamicSettings settings = moving_settings("neo-hookean", WaveBar::young, WaveBar::nu);
  const auto solver = make_explicit_solver(bar.body.levels[0], bar.body.loading, settings);
  bar.begin(*solver);
  const double dt = 2 * std::numbers::pi / bar.frequency() / steps_of_period;
  double largest = 0;
  for (int k = 1; k <= 2 * steps_of_period; ++k) {
    (void)solver->step(dt, 1);
    largest = std::max(largest, std::abs(bar.part(*solver) - std::cos(bar.frequency() * k * dt)));
  }
  return largest;
}

TEST(ExplicitDynamics, errors_halve_with_the_time_step) {
  const double coarse = mode_error(80), fine = mode_error(160), finest = mode_error(320);
  EXPECT_NEAR(coarse / fine, 2, 0.1);
  EXPECT_NEAR(fine / finest, 2, 0.05);
}

/// How far the energy of a body that swings by a fifth of its length is from that at the beginning, in the first and in
/// the last quarter of the time.
std::array<double, 2> energy_errors(double part_of_stable, int steps) {
  const Body body = free_body(3, side);
  const auto& rest = body.levels[0].rest;
  const DynamicSettings settings = moving_settings("neo-hookean", 1e4, 0.4);
  const auto solver = make_explicit_solver(body.levels[0], body.loading, settings);
  std::vector<Point> stretched = rest;
  for (Point& x : stretched) x = {0.9 * x[0], 0.9 * x[1], 1.2 * x[2]};
  solver->set_positions(stretched);
  const double dt = part_of_stable * stable_time_step(body.levels[0], settings);
  const auto energy = [&] {
    const MotionMeasure measure = solver->measure();
    return measure.kinetic + measure.elastic;
  };
  const double begin = energy();
  std::array<double, 2> largest{};
  for (int k = 1; k <= steps; ++k) {
    (void)solver->step(dt, 1);
    const double error = std::abs(energy() / begin - 1);
    if (4 * k <= steps) largest[0] = std::max(largest[0], error);
    if (4 * k > 3 * steps) largest[1] = std::max(largest[1], error);
  }
  return largest;
}

TEST(ExplicitDynamics, energy_stays_within_bounds_that_shrink_with_the_time_step) {
  const auto [first, last] = energy_errors(0.4, 4000);
  EXPECT_GT(first, 1e-4);  // it is not measured to be constant
  EXPECT_LT(first, 0.1);
  EXPECT_LT(last, 1.5 * first);
  const double halved = energy_errors(0.2, 2000)[0];
  EXPECT_NEAR(first / halved, 2, 0.5);
}

TEST(ExplicitDynamics, steps_that_are_said_to_be_stable_are_below_the_limit_and_not_far) {
  for (const double nu : {0.0, 0.3, 0.45, 0.49}) {
    for (const double jitter : {0.0, 0.25}) {
      const Body body = make_cube(
          4, side, false, jitter, [](const Point& x) { return std::uint8_t(x[2] == 0 ? 7 : 0); },
          [](const Point&) { return Point{}; });
      const DynamicSettings settings = moving_settings("neo-hookean", 1e4, nu);
      const double limit = 2 / highest_frequency(body.levels[0], settings, 400);
      const double said = stable_time_step(body.levels[0], settings);
      EXPECT_LE(said, limit) << nu << " " << jitter;
      EXPECT_GE(said, limit / (jitter > 0 ? 5 : 3)) << nu << " " << jitter;
    }
  }
}

/// How far a body at rest but for a tiny disturbance gets in 400 steps of a length, in disturbances.
double growth(double part_of_limit) {
  const Body body = free_body(3, side);
  const auto& rest = body.levels[0].rest;
  const DynamicSettings settings = moving_settings("neo-hookean", 1e4, 0.45);
  const auto solver = make_explicit_solver(body.levels[0], body.loading, settings);
  constexpr double disturbance = 1e-9 * side;
  solver->set_positions(sum(rest, random_vectors(rest.size(), disturbance, 8)));
  const double dt = part_of_limit * 2 / highest_frequency(body.levels[0], settings, 2000);
  for (int k = 0; k < 400; ++k) (void)solver->step(dt, 1);
  if (!solver->measure().is_finite()) return INFINITY;
  return largest_distance(solver->positions(), rest) / disturbance;
}

TEST(ExplicitDynamics, the_limit_of_stability_is_two_over_the_highest_frequency) {
  EXPECT_LT(growth(0.97), 100);
  EXPECT_GT(growth(1.03), 1e4);
}

TEST(ExplicitDynamics, plates_move_as_prescribed_and_damping_leads_to_equilibrium) {
  const Body body = make_truth_cube_body(4, false);
  const MeshLevel& level = body.levels[0];
  DynamicSettings settings = moving_settings("neo-hookean", 1e4, 0.3);
  settings.damping = 60;
  const auto solver = make_explicit_solver(level, body.loading, settings);
  const double dt = 0.5 * stable_time_step(level, settings);
  constexpr int steps = 3000;
  const auto load_at = [](int k) { return 0.1 * std::min(1.0, k / 500.0); };
  for (int k = 1; k <= steps; ++k) {
    (void)solver->step(dt, load_at(k));
    if (k != 100 && k != steps) continue;
    const auto x = solver->positions(), v = solver->velocities();
    for (std::size_t n = 0; n < x.size(); ++n) {
      for (std::size_t c = 0; c < 3; ++c) {
        if ((level.fixed[n] >> c & 1) == 0) continue;
        EXPECT_NEAR(x[n][c], level.rest[n][c] + load_at(k) * body.loading.motion[n][c], 1e-15);
        EXPECT_NEAR(v[n][c], (load_at(k) - load_at(k - 1)) * body.loading.motion[n][c] / dt, 1e-9);
      }
    }
  }
  SolverSettings statics = settings.solver;
  statics.newton.tolerance = 1e-10;
  const auto quasistatic = make_solver({level}, body.loading, statics);
  ASSERT_EQ(quasistatic->solve_to(0.1, {}).status, NewtonStatus::converged);
  EXPECT_LE(largest_distance(solver->positions(), quasistatic->positions()), 1e-6 * side);
  // Forces at the plates are those of the equilibrium, and so are stresses.
  EXPECT_LE(largest_distance(solver->forces(), quasistatic->forces()), 1e-4 * 1e4 * side * side / 16);
  const auto P = solver->stresses(), expected = quasistatic->stresses();
  for (std::size_t t = 0; t < P.size(); ++t) {
    for (std::size_t k = 0; k < 9; ++k) EXPECT_NEAR(P[t][k], expected[t][k], 1e-4 * 1e4);
  }
}

TEST(ExplicitDynamics, what_it_cannot_do_is_refused_with_a_reason) {
  const auto refusal = [](const Body& body, const DynamicSettings& settings) -> std::string {
    try {
      (void)make_explicit_solver(body.levels[0], body.loading, settings);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const DynamicSettings good = moving_settings("neo-hookean", 1e4, 0.3);
  const Body body = make_truth_cube_body(2, false);
  EXPECT_EQ(refusal(body, good), "");
  EXPECT_NE(refusal(make_truth_cube_body(2, true), good).find("do not average volumes"), std::string::npos);
  EXPECT_NE(refusal(with_contact(body), good).find("cannot have rigid planes"), std::string::npos);
  DynamicSettings settings = good;
  settings.density = 0;
  EXPECT_NE(refusal(body, settings).find("the density is 0 and must be a positive number"), std::string::npos);
  settings = good;
  settings.damping = -1;
  EXPECT_NE(refusal(body, settings).find("the damping is -1"), std::string::npos);
  settings = good;
  settings.solver.material = "jelly";
  EXPECT_NE(refusal(body, settings).find("there is no material 'jelly'"), std::string::npos);
  const auto solver = make_explicit_solver(body.levels[0], body.loading, good);
  EXPECT_THROW((void)solver->step(0, 1), Error);
  EXPECT_THROW((void)solver->step(1e-4, NAN), Error);
  EXPECT_THROW(solver->set_velocities(random_vectors(3, 1, 1)), Error);
}

TEST(ExplicitDynamics, positions_and_velocities_that_are_not_finite_are_refused_and_change_nothing) {
  const Body body = make_truth_cube_body(2, false);
  expect_only_finite_vectors(
      *make_explicit_solver(body.levels[0], body.loading, moving_settings("neo-hookean", 1e4, 0.3)));
}

}  // namespace
}  // namespace physgen::fem
