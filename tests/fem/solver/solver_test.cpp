// Newton's method, multigrid and the state of the solver: how many iterations, from where it recovers, what repeats.
#include <gtest/gtest.h>
#include <physgen/error.h>

#include <algorithm>
#include <cstdio>

#include "bodies.h"

namespace physgen::fem {
namespace {

std::vector<Point> random_forces(std::size_t nodes) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<Point> forces(nodes);
  for (Point& f : forces) f = {number(random), number(random), number(random)};
  return forces;
}

int iterations(Index cells, double poissons_ratio, bool patches, TangentPrecision precision, Preconditioner kind,
               double tolerance) {
  const Body body = make_truth_cube_body(cells, patches);
  SolverSettings settings;
  settings.poissons_ratio = poissons_ratio;
  settings.precision = precision;
  settings.newton.preconditioner.kind = kind;
  const auto solver = make_solver(body.levels, body.loading, settings);
  const LinearResult result = solver->solve_linear(random_forces(body.levels[0].rest.size()), tolerance, nullptr);
  EXPECT_EQ(result.status, LinearStatus::converged);
  EXPECT_LE(result.reduction, tolerance);
  return result.iterations;
}

TEST(Multigrid, takes_few_iterations_that_do_not_grow_with_the_mesh) {
  const struct {
    double poissons_ratio;
    bool patches;
    int most;
  } rows[] = {{.45, false, 12}, {.49, true, 24}, {.499, true, 75}};
  for (const auto& row : rows) {
    std::vector<int> counts;
    for (const Index cells : {8, 16, 32}) {
      counts.push_back(
          iterations(cells, row.poissons_ratio, row.patches, TangentPrecision::half, Preconditioner::multigrid, 1e-4));
    }
    std::printf("nu %g: %d, %d, %d iterations for 8, 16, 32 cells\n", row.poissons_ratio, counts[0], counts[1],
                counts[2]);
    for (const int count : counts) EXPECT_LE(count, row.most) << row.poissons_ratio;
    EXPECT_LE(counts[2], counts[1] * 5 / 4 + 1) << row.poissons_ratio;
  }
}

TEST(Multigrid, stored_in_half_takes_hardly_more_iterations) {
  for (const double poissons_ratio : {.45, .49, .499}) {
    const int half = iterations(16, poissons_ratio, true, TangentPrecision::half, Preconditioner::multigrid, 1e-6);
    const int whole = iterations(16, poissons_ratio, true, TangentPrecision::float32, Preconditioner::multigrid, 1e-6);
    std::printf("nu %g: %d in half, %d in float\n", poissons_ratio, half, whole);
    EXPECT_LE(half, whole + std::max(1, whole / 20)) << poissons_ratio;
  }
}

TEST(Multigrid, and_block_jacobi_and_none_find_the_same_step) {
  const Body body = make_truth_cube_body(8, true);
  std::vector<std::vector<Point>> steps;
  for (const Preconditioner kind : {Preconditioner::multigrid, Preconditioner::block_jacobi, Preconditioner::none}) {
    SolverSettings settings = exact_settings("neo-hookean", 0.45);
    settings.newton.preconditioner.kind = kind;
    const auto solver = make_solver(body.levels, body.loading, settings);
    ASSERT_EQ(solver->solve_to(0.05, {}).status, NewtonStatus::converged);
    steps.emplace_back();
    EXPECT_EQ(solver->solve_linear(random_forces(body.levels[0].rest.size()), 1e-12, &steps.back()).status,
              LinearStatus::converged);
  }
  double largest = 0;
  for (const Point& x : steps[0]) largest = std::max({largest, std::abs(x[0]), std::abs(x[1]), std::abs(x[2])});
  ASSERT_GT(largest, 0);
  EXPECT_LE(largest_distance(steps[0], steps[1]), 1e-8 * largest);
  EXPECT_LE(largest_distance(steps[0], steps[2]), 1e-8 * largest);
}

/// The step of a linear solve is the inverse of the change of forces: found by differences, without any stiffness.
TEST(Tangent, is_the_derivative_of_the_forces) {
  for (const bool patches : {false, true}) {
    const Body body = make_truth_cube_body(4, patches);
    const auto solver = make_solver(body.levels, body.loading, exact_settings("neo-hookean", 0.45));
    ASSERT_EQ(solver->solve_to(0.1, {}).status, NewtonStatus::converged);
    const auto at = solver->positions();
    const auto right = random_forces(at.size());
    std::vector<Point> step;
    ASSERT_EQ(solver->solve_linear(right, 1e-13, &step).status, LinearStatus::converged);
    const auto forces_at = [&](double length) {
      std::vector<Point> moved = at;
      for (std::size_t n = 0; n < at.size(); ++n) {
        for (std::size_t k = 0; k < 3; ++k) moved[n][k] += length * step[n][k];
      }
      solver->set_positions(moved);
      return solver->forces();
    };
    double largest = 0;
    for (const Point& x : step) largest = std::max({largest, std::abs(x[0]), std::abs(x[1]), std::abs(x[2])});
    const double length = 1e-7 / largest;
    const auto up = forces_at(length), down = forces_at(-length);
    for (std::size_t n = 0; n < at.size(); ++n) {
      if (body.levels[0].fixed[n] != 0) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR((up[n][k] - down[n][k]) / (2 * length), -right[n][k], 2e-5) << patches << " " << n;
      }
    }
  }
}

TEST(Multigrid, many_power_iterations_do_not_overflow) {
  const Body body = make_truth_cube_body(8, true);
  SolverSettings settings;
  settings.newton.preconditioner.first_power_steps = 200;
  const auto solver = make_solver(body.levels, body.loading, settings);
  const NewtonResult result = solver->solve_to(0.05, {});
  EXPECT_EQ(result.status, NewtonStatus::converged);
  EXPECT_EQ(result.filtered, 0);
}

TEST(Newton, nested_steps_and_load_steps_lead_to_the_same_state) {
  const Body body = make_truth_cube_body(16, true);
  std::vector<std::vector<Point>> found;
  for (const bool nested : {true, false}) {
    SolverSettings settings = exact_settings("neo-hookean", 0.49);
    settings.precision = TangentPrecision::half;
    settings.newton.tolerance = 1e-8;
    settings.nested = nested;
    const auto solver = make_solver(body.levels, body.loading, settings);
    const NewtonResult result = solver->solve_to(0.125, {});
    ASSERT_EQ(result.status, NewtonStatus::converged);
    EXPECT_LE(result.steps, 6);
    EXPECT_EQ(result.halvings, 0);
    EXPECT_EQ(result.filtered, 0);
    found.push_back(solver->positions());
  }
  EXPECT_LE(largest_distance(found[0], found[1]), 1e-9);
}

TEST(Newton, takes_few_steps_and_no_shortened_ones_in_three_load_steps) {
  for (const double poissons_ratio : {.45, .49, .499}) {
    const Body body = make_truth_cube_body(16, poissons_ratio > .45);
    SolverSettings settings;
    settings.poissons_ratio = poissons_ratio;
    settings.nested = false;
    const auto solver = make_solver(body.levels, body.loading, settings);
    for (const double compression : {.05, .125, .1825}) {
      const NewtonResult result = solver->solve_to(compression, {});
      ASSERT_EQ(result.status, NewtonStatus::converged);
      EXPECT_LE(result.steps, 5) << poissons_ratio << " " << compression;
      EXPECT_EQ(result.halvings, 0);
      EXPECT_GT(result.smallest_J, 0);
    }
  }
}

TEST(Newton, residual_of_1e_8_is_reached_at_every_poissons_ratio_with_a_tangent_in_half) {
  for (const double poissons_ratio : {.3, .45, .49, .499}) {
    const Body body = make_truth_cube_body(16, true);
    SolverSettings settings;
    settings.poissons_ratio = poissons_ratio;
    settings.newton.tolerance = 1e-8;
    const auto solver = make_solver(body.levels, body.loading, settings);
    const NewtonResult result = solver->solve_to(0.1, {});
    EXPECT_EQ(result.status, NewtonStatus::converged) << poissons_ratio;
    EXPECT_LE(result.residual, 1e-8);
  }
}

TEST(Restart, goes_on_bit_for_bit) {
  const Body body = make_truth_cube_body(8, true);
  SolverSettings settings;
  settings.poissons_ratio = .49;
  const auto whole = make_solver(body.levels, body.loading, settings);
  ASSERT_EQ(whole->solve_to(0.05, {}).status, NewtonStatus::converged);
  const SolverState kept = whole->state();
  ASSERT_EQ(whole->solve_to(0.125, {}).status, NewtonStatus::converged);
  const auto later = make_solver(body.levels, body.loading, settings);
  later->restore(kept);
  EXPECT_EQ(later->load(), 0.05);
  ASSERT_EQ(later->solve_to(0.125, {}).status, NewtonStatus::converged);
  EXPECT_EQ(later->positions(), whole->positions());
  EXPECT_EQ(later->forces(), whole->forces());
}

/// Whether a cube that is put somewhere is itself again after a solve, wherever and however it is turned then.
/// @param held the base stays where it is; else nothing holds the cube
bool returns(const std::string& material, bool held, std::uint64_t seed,
             const std::function<Point(const Point&, std::mt19937_64&)>& start) {
  constexpr double side = 0.08;
  const auto is_held = [=](const Point& x) { return held && x[2] == 0; };
  const Body body = make_cube(
      4, side, false, 0, [=](const Point& x) -> std::uint8_t { return is_held(x) ? 7 : 0; },
      [](const Point&) { return Point{}; });
  SolverSettings settings = exact_settings(material, 0.45);
  settings.nested = false;
  settings.newton.preconditioner.kind = Preconditioner::block_jacobi;
  settings.newton.most_steps = 40;
  settings.newton.tolerance = 1e-9;
  const auto solver = make_solver(body.levels, body.loading, settings);
  std::mt19937_64 random(seed);
  std::vector<Point> positions;
  for (const Point& x : body.levels[0].rest) positions.push_back(is_held(x) ? x : start(x, random));
  solver->set_positions(positions);
  const NewtonResult result = solver->solve_to(0, {});
  const auto found = solver->positions();
  const auto& rest = body.levels[0].rest;
  double largest = 0;  // change of a distance between nodes
  for (std::size_t n = 0; n < rest.size(); ++n) {
    for (const std::size_t m : {std::size_t{0}, rest.size() / 2, rest.size() - 1}) {
      const auto distance = [&](const std::vector<Point>& x) {
        return std::hypot(x[n][0] - x[m][0], x[n][1] - x[m][1], x[n][2] - x[m][2]);
      };
      largest = std::max(largest, std::abs(distance(found) - distance(rest)));
    }
  }
  EXPECT_GE(result.returns, 1);
  std::printf("  %d Newton steps, %d shortened, %d filtered, %d returns; energy %.3e, smallest J %.4f\n", result.steps,
              result.halvings, result.filtered, result.returns, result.energy, result.smallest_J);
  return result.status == NewtonStatus::converged && largest <= 1e-6 * side;
}

/// From where Newton's method alone ends in other equilibria, without inverted tets, in 9 of 12 cases.
TEST(Recovery, flattened_collapsed_inverted_and_random_cubes_return_to_rest) {
  for (const std::string material : {"stable-neo-hookean", "fixed-corotated"}) {
    for (const bool held : {false, true}) {
      std::printf("%s%s: flattened, collapsed, inverted, random with seeds 1 to 5\n", material.c_str(),
                  held ? ", held" : "");
      EXPECT_TRUE(returns(material, held, 0, [](const Point& x, auto&) { return Point{x[0], x[1], 0}; }));
      EXPECT_TRUE(returns(material, held, 0, [](const Point&, auto&) { return Point{0.04, 0.04, 0.04}; }));
      EXPECT_TRUE(returns(material, held, 0, [](const Point& x, auto&) { return Point{x[0], x[1], -x[2]}; }));
      for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        EXPECT_TRUE(returns(material, held, seed, [](const Point&, auto& random) {
          std::uniform_real_distribution<double> at(0, 0.08);
          const double a = at(random), b = at(random), c = at(random);
          return Point{a, b, c};
        })) << seed;
      }
    }
  }
}

/// A start without inverted tets is not changed, however far from rest it is.
TEST(Recovery, from_a_start_without_inverted_tets_begins_there) {
  const Body body = make_truth_cube_body(4, false);
  SolverSettings settings = exact_settings("stable-neo-hookean", 0.45);
  settings.nested = false;
  const auto solver = make_solver(body.levels, body.loading, settings);
  auto positions = body.levels[0].rest;
  for (Point& x : positions) x[2] *= 0.2;
  solver->set_positions(positions);
  const NewtonResult result = solver->solve_to(0, {});
  EXPECT_EQ(result.status, NewtonStatus::converged);
  EXPECT_EQ(result.returns, 0);
  EXPECT_LE(largest_distance(solver->positions(), body.levels[0].rest), 1e-9);
}

TEST(BadInput, is_refused_with_its_name_value_and_remedy) {
  const Body body = make_truth_cube_body(2, true);
  const auto message = [&](const std::function<void(SolverSettings&, Loading&, std::vector<MeshLevel>&)>& spoil) {
    SolverSettings settings;
    Loading loading = body.loading;
    auto levels = body.levels;
    spoil(settings, loading, levels);
    try {
      (void)make_solver(levels, loading, settings);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  const auto expect = [](const std::string& text, std::initializer_list<const char*> words) {
    for (const char* word : words) EXPECT_NE(text.find(word), std::string::npos) << word << " in: " << text;
  };
  expect(message([](auto& s, auto&, auto&) { s.material = "steel"; }), {"steel", "neo-hookean", "mooney-rivlin"});
  expect(message([](auto& s, auto&, auto&) { s.material = "corotated"; }), {"corotated", "patches", "neo-hookean"});
  expect(message([](auto& s, auto&, auto&) { s.poissons_ratio = 0.5; }), {"0.5", "Poisson"});
  expect(message([](auto& s, auto&, auto&) { s.youngs_modulus = -1; }), {"-1", "Young"});
  expect(message([](auto& s, auto&, auto&) { s.newton.tolerance = 0; }), {"tolerance", "positive"});
  expect(message([](auto& s, auto&, auto&) { s.newton.most_iterations = 0; }), {"iterations", "0", "1 or more"});
  expect(message([](auto& s, auto&, auto&) { s.newton.most_steps = -3; }), {"Newton steps", "-3", "1 or more"});
  expect(message([](auto& s, auto&, auto&) { s.newton.preconditioner.degree = 0; }), {"degree", "0"});
  expect(message([](auto& s, auto&, auto&) { s.newton.preconditioner.low = 1; }), {"interval", "below 1"});
  expect(message([](auto& s, auto&, auto&) { s.newton.preconditioner.first_power_steps = 0; }), {"power", "0"});
  expect(message([](auto&, auto& l, auto&) { l.motion.pop_back(); }), {"motion", "26", "27"});
  expect(message([](auto&, auto& l, auto&) { l.motion[5][1] = NAN; }), {"node 5", "finite"});
  expect(message([](auto&, auto&, auto& m) { m[0].fixed.pop_back(); }), {"constraints", "26"});
  expect(message([](auto&, auto&, auto& m) {
           m[0].patches = {};
           m.clear();
         }),
         {"one tet"});
}

}  // namespace
}  // namespace physgen::fem
