// Pressure that follows the surface: against exact states, turned, in balance, and its tangent against differences.
#include <fem/materials/material.h>
#include <gtest/gtest.h>
#include <physgen/error.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>

#include "grouped_bar.h"

namespace physgen::fem {
namespace {

std::vector<GroupPressure> on_all_sides(double pressure) {
  std::vector<GroupPressure> pressures;
  for (const char* side : {"x0", "x1", "y0", "y1", "z0", "z1"}) pressures.push_back({side, pressure, true});
  return pressures;
}

/// The stretch of a Neo-Hookean body under a pressure from all sides that follows them.
double squeezed(const LameParameters& lame, double pressure) {
  double low = 0.3, high = 1.5;
  for (int k = 0; k < 200; ++k) {
    const double s = (low + high) / 2;
    (lame.mu * (s * s - 1) + 3 * lame.lambda * std::log(s) < -pressure * s * s * s ? low : high) = s;
  }
  return low;
}

TEST(FollowingPressure, on_all_sides_squeezes_a_body_to_its_exact_size_without_reactions) {
  constexpr double nu = 0.4, young = 1e4;
  const LameParameters lame = lame_parameters(young, nu, "test");
  for (const auto& [patches, refinements] : {std::pair{false, 0}, std::pair{true, 0}, std::pair{true, 1}}) {
    GroupedBar bar(patches, refinements);
    LoadCase load_case{symmetric(), {}, {}, on_all_sides(5e3), {}, 0};
    const Loading loading = apply_load_case(load_case, bar.levels, bar.groups);
    SolverSettings settings = settings_of(nu);
    settings.nested = refinements > 0;
    settings.coarsest_nested = 0;
    const auto solver = make_solver(bar.levels, loading, settings);
    for (const double load : {1.0, -0.2, 2.0}) {
      int last = 0;
      const NewtonResult result =
          solver->solve_to(load, [&](std::size_t, const NewtonStep& step) { last = step.number; });
      ASSERT_EQ(result.status, NewtonStatus::converged) << load;
      EXPECT_LE(last, 9);  // the tangent is exact: the surface is closed
      const double pressure = 5e3 * load, s = squeezed(lame, pressure), volume = size[0] * size[1] * size[2];
      EXPECT_GT(std::abs(1 - s), 0.01);
      const auto positions = solver->positions();
      for (std::size_t n = 0; n < positions.size(); ++n) {
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_NEAR(positions[n][k], s * bar.levels[0].rest[n][k], 1e-9) << patches << refinements << load;
        }
      }
      const double log = 3 * std::log(s);
      const double elastic = lame.mu * (1.5 * (s * s - 1) - log) + lame.lambda / 2 * log * log;
      EXPECT_NEAR(result.energy, volume * (elastic + pressure * (s * s * s - 1)), 1e-8 * volume * std::abs(pressure));
      for (const char* side : {"x0", "y0", "z0"}) {
        const Point held = reaction_of(bar.group(side).nodes, bar.levels[0], solver->forces());
        for (const double component : held) EXPECT_NEAR(component, 0, 1e-7);
      }
    }
  }
}

/// A cantilever that is bent by a pressure on its side, far.
LoadCase bent() { return {{{"z0"}}, {}, {}, {{"x1", 250, true}, {"y1", 60}}, {0, 0, -1}, 500}; }

TEST(FollowingPressure, is_balanced_by_reactions_along_the_normals_that_the_surface_has_then) {
  for (const int refinements : {0, 1}) {
    GroupedBar bar(refinements > 0, refinements);
    const Loading loading = apply_load_case(bent(), bar.levels, bar.groups);
    SolverSettings settings = settings_of(0.4);
    settings.nested = refinements > 0;
    settings.coarsest_nested = 0;
    const auto solver = make_solver(bar.levels, loading, settings);
    int steps = 0;
    ASSERT_EQ(solver->solve_to(1, [&](std::size_t, const NewtonStep&) { ++steps; }).status, NewtonStatus::converged);
    RecordProperty("newton_steps_of_an_open_surface_" + std::to_string(refinements), steps);
    const auto positions = solver->positions();
    EXPECT_GT(largest_distance(positions, bar.levels[0].rest), 0.05);
    const auto pushed = pressure_loads(positions, loading.pressures[0].faces, 250);
    const Point dead = sum_of(bar.group("all").nodes, loading.forces), follows = sum_of(bar.group("all").nodes, pushed);
    const Point held = reaction_of(bar.group("z0").nodes, bar.levels[0], solver->forces());
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(held[k], -dead[k] - follows[k], 1e-8) << k;
    EXPECT_GT(std::abs(follows[2]), 0.3);  // N: it has turned with the surface
  }
}

TEST(FollowingPressure, on_a_turned_body_gives_a_turned_result) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(-1.9, Eigen::Vector3d(2, -1, 0.3).normalized()).toRotationMatrix();
  const auto seen = [&](const Point& x) {
    const Eigen::Vector3d y = turn * Eigen::Vector3d(x.data());
    return Point{y[0] + 3, y[1] - 1, y[2] + 2};
  };
  const auto solve = [&](bool turns) {
    GroupedBar bar(true);
    LoadCase load_case = bent();
    load_case.gravity = {};
    if (turns) {
      for (Point& x : bar.levels[0].rest) x = seen(x);
    }
    const auto solver = make_solver(bar.levels, apply_load_case(load_case, bar.levels, bar.groups), settings_of(0.4));
    EXPECT_EQ(solver->solve_to(1, {}).status, NewtonStatus::converged);
    return solver->positions();
  };
  std::vector<Point> straight = solve(false);
  for (Point& x : straight) x = seen(x);
  EXPECT_LT(largest_distance(straight, solve(true)), 1e-8);
}

TEST(FollowingPressure, has_a_tangent_that_is_exact_where_the_surface_is_closed_and_else_its_symmetric_part) {
  constexpr unsigned seed = 17;
  std::printf("seed %u\n", seed);
  for (const bool closed : {true, false}) {
    GroupedBar bar;
    LoadCase load_case{symmetric(), {}, {}, on_all_sides(4e3), {}, 0};
    if (!closed) load_case.pressures.resize(3);
    const auto solver = make_solver(bar.levels, apply_load_case(load_case, bar.levels, bar.groups), settings_of());
    ASSERT_EQ(solver->solve_to(1, {}).status, NewtonStatus::converged);
    std::mt19937 random(seed);
    std::normal_distribution<double> number(0, 1);
    const auto any = [&](double length) {
      std::vector<Point> v(bar.levels[0].rest.size());
      for (std::size_t n = 0; n < v.size(); ++n) {
        for (std::size_t k = 0; k < 3; ++k) v[n][k] = length * number(random);
      }
      return v;
    };
    const auto moved = [](std::vector<Point> x, const std::vector<Point>& d, double factor) {
      for (std::size_t n = 0; n < x.size(); ++n) {
        for (std::size_t k = 0; k < 3; ++k) x[n][k] += factor * d[n][k];
      }
      return x;
    };
    const std::vector<Point> at = moved(bar.levels[0].rest, any(0.004), 1), u = any(1), v = any(1);
    const auto dot = [](const std::vector<Point>& a, const std::vector<Point>& b) {
      double sum = 0;
      for (std::size_t n = 0; n < a.size(); ++n) sum += std::inner_product(a[n].begin(), a[n].end(), b[n].begin(), 0.0);
      return sum;
    };
    // v . df/dx u by central differences.
    const auto difference = [&](const std::vector<Point>& along, const std::vector<Point>& with) {
      constexpr double h = 1e-7;
      solver->set_positions(moved(at, along, h));
      const auto ahead = solver->forces();
      solver->set_positions(moved(at, along, -h));
      return (dot(with, ahead) - dot(with, solver->forces())) / (2 * h);
    };
    const double vu = difference(u, v), uv = difference(v, u);
    solver->set_positions(at);
    const AssembledStiffness K = solver->stiffness();
    const double product = dot(v, K.product(u));
    const double scale = std::abs(vu);
    EXPECT_NEAR(product, (vu + uv) / 2, 1e-5 * scale) << closed;
    if (closed) {
      EXPECT_NEAR(vu, uv, 1e-5 * scale);
    } else {
      EXPECT_GT(std::abs(vu - uv), 1e-4 * scale);  // or there is nothing to make symmetric
    }
  }
}

TEST(FollowingPressure, that_no_solver_takes_is_refused) {
  const auto refusal = [](const auto& change) {
    GroupedBar bar(false, 1);
    Loading loading = apply_load_case(bent(), bar.levels, bar.groups);
    SolverSettings settings = settings_of();
    settings.nested = true;
    settings.coarsest_nested = 0;
    try {
      change(loading, settings);
      static_cast<void>(make_solver(bar.levels, loading, settings));
    } catch (const Error& error) {
      return std::string(error.what()).substr(std::string("physgen: ").size());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(refusal([](Loading&, SolverSettings&) {}), "accepted");
  EXPECT_EQ(refusal([](Loading& loading, SolverSettings&) { loading.pressures[0].pressure = NAN; }),
            "pressure 0 that follows the surface is nan and must be a finite number [Pa]");
  EXPECT_TRUE(refusal([](Loading& loading, SolverSettings&) {
                loading.pressures[0].faces[0][1] = -3;
              }).starts_with("pressure 0 that follows the surface pushes a face with node -3 of "));
  EXPECT_TRUE(refusal([](Loading& loading, SolverSettings&) {
                loading.pressures[0].faces.pop_back();
              }).ends_with("make levels by refine(), or take no nested steps"));
  EXPECT_TRUE(refusal([](Loading& loading, SolverSettings& settings) {
                settings.nested = false;
                loading.pressures[0].faces[0] = {0, 1, static_cast<Index>(loading.motion.size()) - 1};
              }).ends_with("which no tet has as an edge; give faces of the mesh's surface"));
  EXPECT_EQ(refusal([](Loading&, SolverSettings& settings) { settings.newton.product = Product::matrix_free; }),
            "pressures that follow the surface require the assembled product: the matrix-free one has only the "
            "stiffness of tets");
}

}  // namespace
}  // namespace physgen::fem
