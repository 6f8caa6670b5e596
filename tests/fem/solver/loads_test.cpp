// External forces: reactions that balance them, and a bar pulled and pressed by its end face, to its limit load; and
// increments that are too large for Newton's method.
#include <fem/mesh/boundary.h>
#include <fem/mesh/graded_cube.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "bodies.h"
#include "irregular.h"

namespace physgen::fem {
namespace {

SolverSettings own_settings(const std::string& material, double poissons_ratio) {
  SolverSettings settings = exact_settings(material, poissons_ratio);
  settings.newton.preconditioner.kind = Preconditioner::block_jacobi;
  settings.nested = false;
  return settings;
}

std::vector<Face> faces_where(const MeshLevel& level, const std::function<bool(const Point&)>& on) {
  std::vector<Face> faces = boundary_faces(level.mesh);
  std::erase_if(faces, [&](const Face& face) {
    return !std::ranges::all_of(face, [&](Index n) { return on(level.rest[static_cast<std::size_t>(n)]); });
  });
  return faces;
}

/// The force that holds prescribed components: the sum of minus the forces there [N].
Point reaction(const MeshLevel& level, const std::vector<Point>& forces) {
  Point sum{};
  for (std::size_t n = 0; n < forces.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) {
      if ((level.fixed[n] >> k & 1) != 0) sum[k] -= forces[n][k];
    }
  }
  return sum;
}

TEST(Loads, of_gravity_and_pressure_are_balanced_by_the_reactions_at_every_load) {
  constexpr double density = 1000, pressure = 0.04;
  const std::array<double, 3> gravity{2e-3, -1e-3, -9.81e-4};
  const Tets tets = shuffled(irregular_box({3, 3, 3}, {side, side, side}, 0.2, 23), 29);
  for (const bool patches : {false, true}) {
    const auto levels = make_levels(tets, 1, patches, [](const Point& x) -> std::uint8_t { return x[2] == 0 ? 7 : 0; });
    const MeshLevel& level = levels[0];
    Loading loading;
    loading.motion.assign(level.rest.size(), Point{});
    loading.forces = gravity_loads(level.mesh, level.rest, density, gravity);
    const auto pressed =
        pressure_loads(level.rest, faces_where(level, [](const Point& x) { return x[0] == side; }), pressure);
    for (std::size_t n = 0; n < pressed.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) loading.forces[n][k] += pressed[n][k];
    }
    const double weight = density * side * side * side, thrust = pressure * side * side;
    const Point total{weight * gravity[0] - thrust, weight * gravity[1], weight * gravity[2]};
    const double size = std::hypot(total[0], total[1], total[2]);
    SolverSettings settings = exact_settings("neo-hookean", 0.45);
    settings.coarsest_nested = 0;
    const auto solver = make_solver(levels, loading, settings);
    for (const double load : {0.5, 1.0}) {
      const NewtonResult result = solver->solve_to(load, {});
      ASSERT_EQ(result.status, NewtonStatus::converged);
      EXPECT_GT(result.coarse_steps, 0);
      EXPECT_LE(result.steps, 5);  // the coarser mesh had loads that fit
      const auto forces = solver->forces();
      const Point held = reaction(level, forces);
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(held[k], -load * total[k], 1e-9 * size) << patches << " " << k;
      const double moved = largest_distance(solver->positions(), level.rest);
      EXPECT_GT(moved, 0.01 * side);
      std::printf("load %g, %s: moved by up to %.2f mm in %d Newton steps after %d on the coarser mesh\n", load,
                  patches ? "patches" : "tets", 1e3 * moved, result.steps, result.coarse_steps);
    }
  }
}

/// Principal stresses P1 and P2 over E, and the energy over E, of the stretches l, y, y.
struct Bar {
  double along, across, energy;
};
Bar bar(const std::string& material, double nu, double l, double y) {
  const double mu = 1 / (2 * (1 + nu)), lambda = nu / ((1 + nu) * (1 - 2 * nu)), J = l * y * y,
               I1 = l * l + 2 * y * y - 3, T = l + 2 * y - 3, squares = (l - 1) * (l - 1) + 2 * (y - 1) * (y - 1);
  if (material == "neo-hookean") {
    const double q = mu - lambda * std::log(J);
    return {mu * l - q / l, mu * y - q / y, mu / 2 * I1 - mu * std::log(J) + lambda / 2 * std::log(J) * std::log(J)};
  }
  if (material == "st-venant-kirchhoff") {
    const double e = (l * l - 1) / 2, f = (y * y - 1) / 2;
    return {l * (2 * mu * e + lambda / 2 * I1), y * (2 * mu * f + lambda / 2 * I1),
            mu * (e * e + 2 * f * f) + lambda / 8 * I1 * I1};
  }
  if (material == "corotated") {
    return {2 * mu * (l - 1) + lambda * T, 2 * mu * (y - 1) + lambda * T, mu * squares + lambda / 2 * T * T};
  }
  if (material == "fixed-corotated") {
    const double w = lambda * (J - 1);
    return {2 * mu * (l - 1) + w * y * y, 2 * mu * (y - 1) + w * l * y, mu * squares + lambda / 2 * (J - 1) * (J - 1)};
  }
  const double k = lambda + mu, a = 1 + mu / k, w = k * (J - a);  // stable-neo-hookean
  const double at_rest = k / 2 * (1 - a) * (1 - a);
  return {mu * l + w * y * y, mu * y + w * l * y, mu / 2 * I1 + k / 2 * (J - a) * (J - a) - at_rest};
}

/// The side stretch without stress across, and the stretch whose nominal stress is given, both by bisection.
double side_stretch(const std::string& material, double nu, double l) {
  double low = 0.7, high = 1.4;
  for (int k = 0; k < 100; ++k) {
    const double y = (low + high) / 2;
    (bar(material, nu, l, y).across < 0 ? low : high) = y;
  }
  return low;
}
/// @pre the stress grows with the stretch from 0.58 up
double stretch_under(const std::string& material, double nu, double stress) {
  double low = 0.58, high = 1.4;
  for (int k = 0; k < 100; ++k) {
    const double l = (low + high) / 2;
    (bar(material, nu, l, side_stretch(material, nu, l)).along < stress ? low : high) = l;
  }
  return low;
}

/// A bar with planes of symmetry on three faces, and its end face pulled by a nominal stress at a load of 1.
struct PulledBar {
  PulledBar(bool patches, double stress)
      : levels(make_levels(irregular_tets(), 0, patches, [](const Point& x) {
          return static_cast<std::uint8_t>((x[0] == 0 ? 1 : 0) | (x[1] == 0 ? 2 : 0) | (x[2] == 0 ? 4 : 0));
        })) {
    const auto& rest = levels[0].rest;
    loading.motion.assign(rest.size(), Point{});
    loading.forces =
        pressure_loads(rest, faces_where(levels[0], [](const Point& x) { return x[2] == size[2]; }), -stress);
  }
  /// Every node's place when the bar is stretched by l and across by y.
  [[nodiscard]] std::vector<Point> stretched(double l, double y) const {
    return at_nodes(levels[0].rest, [=](const Point& x) { return Point{y * x[0], y * x[1], l * x[2]}; });
  }
  static const Tets& irregular_tets() {
    static const Tets tets = shuffled(irregular_box({2, 2, 5}, size, 0.2, 31), 37);
    return tets;
  }

  static constexpr Point size{0.5 * side, 0.75 * side, 2 * side};
  std::vector<MeshLevel> levels;
  Loading loading;
};

void expect_bar(const std::string& material, bool patches, double stress) {
  constexpr double nu = 0.45;
  const PulledBar body(patches, stress);
  SolverSettings settings = own_settings(material, nu);
  settings.newton.tolerance = 1e-12;
  const auto solver = make_solver(body.levels, body.loading, settings);
  const NewtonResult result = solver->solve_to(1, {});
  ASSERT_EQ(result.status, NewtonStatus::converged) << material << " " << stress;
  const double l = stretch_under(material, nu, stress), y = side_stretch(material, nu, l);
  EXPECT_LE(largest_distance(solver->positions(), body.stretched(l, y)), 1e-8 * side) << material << " " << stress;
  for (const auto& P : solver->stresses()) {
    EXPECT_NEAR(P[8], stress, 1e-8 * std::abs(stress)) << material;
    EXPECT_NEAR(P[0], 0, 1e-8 * std::abs(stress)) << material;
  }
  const double volume = PulledBar::size[0] * PulledBar::size[1] * PulledBar::size[2];
  const double energy = volume * (bar(material, nu, l, y).energy - stress * (l - 1));
  EXPECT_NEAR(result.energy, energy, 1e-8 * std::abs(energy)) << material << " " << stress;
}

TEST(Loads, pulling_or_pressing_an_end_face_stretch_a_bar_as_its_nominal_stress_says) {
  for (const std::string material :
       {"neo-hookean", "st-venant-kirchhoff", "corotated", "fixed-corotated", "stable-neo-hookean"}) {
    for (const double stress : {0.2, -0.1}) {
      expect_bar(material, false, stress);
      if (can_average_volume(material)) expect_bar(material, true, stress);
    }
  }
}

/// St Venant-Kirchhoff's bar bears no more than E / (3 sqrt(3)), at a stretch of 1 / sqrt(3); beyond that, only turned
/// inside out.
TEST(Loads, pressing_a_bar_beyond_its_limit_load_ends_in_the_last_equilibrium_below_or_turns_it_inside_out) {
  constexpr double nu = 0.3, stress = -0.3, limit = 0.19245008972987526 / 0.3;
  const char* material = "st-venant-kirchhoff";
  const PulledBar body(false, stress);
  const SolverSettings settings = own_settings(material, nu);
  const auto solver = make_solver(body.levels, body.loading, settings);
  const NewtonResult result = solver->solve_to(1, {});
  std::printf("ended at %.4f of the limit load, smallest J %.3g, %d bisections\n", solver->load() / limit,
              result.smallest_J, result.bisections);
  if (result.status == NewtonStatus::converged) {
    EXPECT_EQ(solver->load(), 1);
    EXPECT_LT(result.smallest_J, 0);
    return;
  }
  EXPECT_GE(result.bisections, settings.most_bisections);
  EXPECT_LT(solver->load(), limit);
  EXPECT_GE(solver->load(), 0.95 * limit);
  const double l = stretch_under(material, nu, solver->load() * stress);
  EXPECT_LE(largest_distance(solver->positions(), body.stretched(l, side_stretch(material, nu, l))), 1e-8 * side);
}

std::vector<MeshLevel> bonded_cube() {
  static const Tets box = irregular_box({4, 4, 4}, {side, side, side}, 0.1, 41);
  return make_levels(box, 0, true, [](const Point& x) -> std::uint8_t { return x[2] == 0 || x[2] == side ? 7 : 0; });
}
Loading pressing(const MeshLevel& level) {
  Loading loading;
  for (const Point& x : level.rest) loading.motion.push_back({0, 0, x[2] == side ? -side : 0});
  return loading;
}

TEST(Bisection, reaches_in_parts_what_newtons_method_does_not_reach_at_once) {
  const auto levels = bonded_cube();
  SolverSettings settings = own_settings("neo-hookean", 0.45);
  const auto whole = make_solver(levels, pressing(levels[0]), settings);
  const NewtonResult at_once = whole->solve_to(0.2, {});
  ASSERT_EQ(at_once.status, NewtonStatus::converged);
  ASSERT_EQ(at_once.bisections, 0);
  settings.newton.most_steps = at_once.steps - 1;
  const auto parts = make_solver(levels, pressing(levels[0]), settings);
  const NewtonResult result = parts->solve_to(0.2, {});
  ASSERT_EQ(result.status, NewtonStatus::converged);
  EXPECT_GE(result.bisections, 1);
  EXPECT_GT(result.steps, at_once.steps);
  EXPECT_EQ(parts->load(), 0.2);
  EXPECT_LE(largest_distance(parts->positions(), whole->positions()), 1e-9 * side);
  EXPECT_NEAR(result.energy, at_once.energy, 1e-9 * at_once.energy);
}

/// Flat cells at bonded faces: the linear step of the whole increment makes volumes of patches negative.
TEST(Bisection, comes_behind_a_part_of_the_first_step_that_turns_nothing_over) {
  constexpr Index cells = 8;
  auto levels = make_cube_levels(cells, side, true, cells);
  ASSERT_EQ(levels.size(), 1u);
  MeshLevel& level = levels.front();
  grade_cube(level.rest, cells, side, 1.8);
  for (const Point& x : level.rest)
    level.fixed[static_cast<std::size_t>(&x - level.rest.data())] = x[2] == 0 || x[2] == side ? 7 : 0;
  const SolverSettings settings = own_settings("neo-hookean", 0.4999);
  const auto at_once = make_solver(levels, pressing(level), settings),
             slowly = make_solver(levels, pressing(level), settings);
  std::vector<NewtonStep> steps;
  const NewtonResult result =
      at_once->solve_to(0.3, [&](std::size_t, const NewtonStep& step) { steps.push_back(step); });
  ASSERT_EQ(result.status, NewtonStatus::converged);
  ASSERT_GE(steps.size(), 2u);
  EXPECT_GE(steps[0].halvings, 1);
  EXPECT_GT(steps[0].smallest_J, 0);
  EXPECT_EQ(steps[1].number, 2);
  for (const double load : {0.1, 0.2, 0.3}) ASSERT_EQ(slowly->solve_to(load, {}).status, NewtonStatus::converged);
  EXPECT_LE(largest_distance(at_once->positions(), slowly->positions()), 1e-8 * side);
}

TEST(Bisection, ends_with_a_reason_at_the_last_load_that_was_reached) {
  const auto levels = bonded_cube();
  SolverSettings settings = own_settings("neo-hookean", 0.45);
  const auto limited = make_solver(levels, pressing(levels[0]), settings);
  ASSERT_EQ(limited->solve_to(0.05, {}).status, NewtonStatus::converged);
  const auto before = limited->positions();

  settings.newton.most_steps = 1;
  settings.most_bisections = 3;
  const auto solver = make_solver(levels, pressing(levels[0]), settings);
  SolverState state = limited->state();
  solver->restore(state);
  const NewtonResult result = solver->solve_to(0.2, {});
  EXPECT_EQ(result.status, NewtonStatus::too_many_steps);
  EXPECT_EQ(result.bisections, 3);
  EXPECT_EQ(result.steps, 4);
  EXPECT_EQ(solver->load(), 0.05);
  EXPECT_EQ(solver->positions(), before);
}

TEST(Bisection, or_none_three_fifths_at_once_lead_where_small_steps_do) {
  const auto levels = bonded_cube();
  for (const std::string& material : material_names()) {
    if (!can_average_volume(material)) continue;
    const SolverSettings settings = own_settings(material, 0.45);
    const auto once = make_solver(levels, pressing(levels[0]), settings),
               slowly = make_solver(levels, pressing(levels[0]), settings);
    const NewtonResult result = once->solve_to(0.6, {});
    std::printf("%s: %d bisections, %d Newton steps, smallest J %.3g\n", material.c_str(), result.bisections,
                result.steps, result.smallest_J);
    ASSERT_EQ(result.status, NewtonStatus::converged) << material;
    for (int k = 1; k <= 12; ++k) {
      ASSERT_EQ(slowly->solve_to(0.05 * k, {}).status, NewtonStatus::converged) << material << " " << k;
    }
    EXPECT_LE(largest_distance(once->positions(), slowly->positions()), 1e-8 * side) << material;
  }
}

}  // namespace
}  // namespace physgen::fem
