// Linear elasticity: states that tets represent exactly, the stiffness at rest of the nonlinear solver, and how far the
// two are apart at small strain.
#include <gtest/gtest.h>
#include <physgen/error.h>

#include "bodies.h"

namespace physgen::fem {
namespace {

constexpr std::array products{Product::assembled, Product::matrix_free};

SolverSettings linear_settings(double poissons_ratio, double tolerance = 1e-13) {
  SolverSettings settings = exact_settings("neo-hookean", poissons_ratio);
  settings.newton.tolerance = tolerance;
  settings.newton.preconditioner.kind = Preconditioner::block_jacobi;
  return settings;
}

/// All of the boundary of an irregular cube follows an affine map.
double patch_test_error(const SolverSettings& settings) {
  const auto affine = [](const Point& x) -> Point {
    return {0.9 * x[0] + 0.07 * x[1] - 0.02 * x[2], 0.05 * x[0] + 1.08 * x[1] + 0.06 * x[2],
            -0.04 * x[0] + 0.03 * x[1] + 0.94 * x[2]};
  };
  const Body body = make_cube(
      4, side, false, 0.2,
      [](const Point& x) -> std::uint8_t {
        const bool outside = x[0] == 0 || x[1] == 0 || x[2] == 0 || x[0] == side || x[1] == side || x[2] == side;
        return outside ? 7 : 0;
      },
      [&](const Point& x) {
        const Point y = affine(x);
        return Point{y[0] - x[0], y[1] - x[1], y[2] - x[2]};
      });
  const auto solver = make_linear_solver(body.levels, body.loading, settings);
  EXPECT_EQ(solver->solve_to(1, {}).status, NewtonStatus::converged);
  std::vector<Point> expected;
  for (const Point& x : body.levels[0].rest) expected.push_back(affine(x));
  return largest_distance(solver->positions(), expected) / side;
}

TEST(LinearElastic, inside_of_an_irregular_mesh_follows_an_affine_boundary) {
  for (const Product product : products) {
    SolverSettings settings = linear_settings(0.45);
    settings.newton.product = product;
    EXPECT_LE(patch_test_error(settings), 1e-12);
    settings.newton.tolerance = 1e-11;
    settings.precision = TangentPrecision::half;
    EXPECT_LE(patch_test_error(settings), 1e-10);
  }
}

TEST(LinearElastic, a_solve_that_runs_out_of_iterations_is_no_equilibrium_and_leaves_the_last_one) {
  const Body body = make_cube(
      4, side, false, 0.2, [](const Point& x) -> std::uint8_t { return x[2] == 0 || x[2] == side ? 7 : 0; },
      [](const Point& x) { return Point{0, 0, -0.1 * x[2]}; });
  SolverSettings settings = linear_settings(0.45, 1e-8);
  const auto enough = make_linear_solver(body.levels, body.loading, settings);
  ASSERT_EQ(enough->solve_to(0.5, {}).status, NewtonStatus::converged);
  const std::vector<Point> equilibrium = enough->positions();
  for (const int iterations : {1, 3}) {
    settings.newton.most_iterations = iterations;
    const auto few = make_linear_solver(body.levels, body.loading, settings);
    few->restore({0.5, true, {equilibrium}});
    EXPECT_EQ(few->solve_to(1, {}).status, NewtonStatus::too_many_steps) << iterations;
    EXPECT_EQ(few->load(), 0.5);
    EXPECT_LE(largest_distance(few->positions(), equilibrium) / side, 1e-15);
  }
}

TEST(LinearElastic, a_bar_narrows_by_poissons_ratio_and_pulls_by_youngs_modulus) {
  for (const double nu : {-0.2, 0.0, 0.3, 0.49}) {
    for (const double stretch : {0.8, 1.1}) {
      const Body body = make_cube(
          3, side, false, 0.2,
          [](const Point& x) {
            return static_cast<std::uint8_t>((x[0] == 0 ? 1 : 0) | (x[1] == 0 ? 2 : 0) |
                                             (x[2] == 0 || x[2] == side ? 4 : 0));
          },
          [&](const Point& x) { return Point{0, 0, (stretch - 1) * x[2]}; });
      const auto solver = make_linear_solver(body.levels, body.loading, linear_settings(nu));
      const NewtonResult result = solver->solve_to(1, {});
      ASSERT_EQ(result.status, NewtonStatus::converged);
      const double y = 1 - nu * (stretch - 1), stress = stretch - 1;  // Young's modulus is 1
      std::vector<Point> expected;
      for (const Point& x : body.levels[0].rest) expected.push_back({y * x[0], y * x[1], stretch * x[2]});
      EXPECT_LE(largest_distance(solver->positions(), expected), 1e-12 * side);
      double force = 0;
      const auto forces = solver->forces();
      for (std::size_t n = 0; n < forces.size(); ++n) {
        if (body.levels[0].rest[n][2] == side) force -= forces[n][2];
      }
      EXPECT_NEAR(force / (side * side), stress, 1e-11);
      for (const auto& P : solver->stresses()) {
        for (std::size_t k = 0; k < 9; ++k) EXPECT_NEAR(P[k], k == 8 ? stress : 0.0, 1e-11);
      }
      EXPECT_NEAR(result.energy, 0.5 * stress * (stretch - 1) * side * side * side, 1e-11 * side * side * side);
      EXPECT_NEAR(result.smallest_J, y * y * stretch, 1e-11);
    }
  }
}

TEST(LinearElastic, blocks_are_those_of_a_nonlinear_body_at_rest) {
  const Body body = make_cube(
      3, side, false, 0.2, [](const Point& x) -> std::uint8_t { return x[2] == 0 ? 7 : 0; },
      [](const Point&) { return Point{}; });
  SolverSettings settings = linear_settings(0.45);
  settings.newton.preconditioner.kind = Preconditioner::none;
  const auto nonlinear = make_solver(body.levels, body.loading, settings);
  const AssembledStiffness expected = nonlinear->stiffness();
  // df of unit displacements, node by node: columns of the linear stiffness.
  for (const std::size_t node : {std::size_t(21), std::size_t(63)}) {
    for (std::size_t component = 0; component < 3; ++component) {
      SolverState state{0, true, {body.levels[0].rest}};
      constexpr double unit = 1e-3;
      state.positions[0][node][component] += unit;
      const auto linear = make_linear_solver(body.levels, body.loading, settings);
      linear->restore(state);
      const auto forces = linear->forces();
      for (std::size_t e = 0; e < expected.edges.size(); ++e) {
        const auto [m, n] = expected.edges[e];
        for (std::size_t k = 0; k < 3; ++k) {
          if (std::size_t(n) == node) {
            EXPECT_NEAR(forces[std::size_t(m)][k] / unit, expected.edge_blocks[e][3 * component + k], 1e-10);
          } else if (std::size_t(m) == node) {
            EXPECT_NEAR(forces[std::size_t(n)][k] / unit, expected.edge_blocks[e][3 * k + component], 1e-10);
          }
        }
      }
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(forces[node][k] / unit, expected.nodes[node][3 * component + k], 1e-10);
      }
    }
  }
}

/// How far the linear and the nonlinear equilibrium are apart, over the largest displacement.
double nonlinear_difference(const Body& body, double load) {
  SolverSettings settings = linear_settings(0.4, 1e-11);
  settings.nested = false;
  settings.newton.preconditioner.kind = Preconditioner::multigrid;
  const auto linear = make_linear_solver(body.levels, body.loading, settings);
  const auto nonlinear = make_solver(body.levels, body.loading, settings);
  EXPECT_EQ(linear->solve_to(load, {}).status, NewtonStatus::converged);
  EXPECT_EQ(nonlinear->solve_to(load, {}).status, NewtonStatus::converged);
  return largest_distance(linear->positions(), nonlinear->positions());
}

TEST(LinearElastic, the_nonlinear_solver_differs_in_second_order_of_the_load) {
  const Body plates = make_truth_cube_body(4, false);
  Body pulled = make_cube(
      4, side, false, 0, [](const Point& x) -> std::uint8_t { return x[2] == 0 ? 7 : 0; },
      [](const Point&) { return Point{}; });
  for (const Point& x : pulled.levels[0].rest) {
    pulled.loading.forces.push_back(x[2] == side ? Point{1e-4, -2e-4, 3e-4} : Point{});
  }
  for (const Body& body : {plates, pulled}) {
    const double coarse = nonlinear_difference(body, 0.004), fine = nonlinear_difference(body, 0.002),
                 finest = nonlinear_difference(body, 0.001);
    EXPECT_GT(finest, 1e-12);
    EXPECT_NEAR(coarse / fine, 4, 0.1);
    EXPECT_NEAR(fine / finest, 4, 0.05);
  }
}

TEST(LinearElastic, every_preconditioner_product_and_precision_finds_one_equilibrium) {
  const Body body = make_truth_cube_body(8, false);
  std::vector<Point> first;
  for (const Product product : products) {
    for (const Preconditioner kind :
         {Preconditioner::multigrid, Preconditioner::schwarz, Preconditioner::block_jacobi, Preconditioner::none}) {
      const bool of_blocks = kind == Preconditioner::multigrid || kind == Preconditioner::schwarz;
      if (product == Product::matrix_free && of_blocks) continue;
      for (const TangentPrecision precision :
           {TangentPrecision::float64, TangentPrecision::float32, TangentPrecision::half}) {
        SolverSettings settings = linear_settings(0.45, 1e-9);
        settings.newton.product = product;
        settings.newton.preconditioner.kind = kind;
        settings.precision = precision;
        const auto solver = make_linear_solver(body.levels, body.loading, settings);
        const NewtonResult result = solver->solve_to(0.1, {});
        ASSERT_EQ(result.status, NewtonStatus::converged);
        EXPECT_LE(result.residual, 1e-9);
        EXPECT_LE(result.steps, precision == TangentPrecision::float64 ? 1 : 4);
        EXPECT_LE(result.iterations, (kind == Preconditioner::multigrid ? 25 : 1000) * result.steps);
        if (first.empty()) first = solver->positions();
        EXPECT_LE(largest_distance(solver->positions(), first), 1e-8 * side);
      }
    }
  }
}

TEST(LinearElastic, one_solve_in_half_reaches_the_tolerance_that_is_usual) {
  const Body body = make_truth_cube_body(8, false);
  SolverSettings settings;
  settings.poissons_ratio = 0.45;
  const auto solver = make_linear_solver(body.levels, body.loading, settings);
  int reports = 0;
  const NewtonResult result = solver->solve_to(0.1, [&](std::size_t level, const NewtonStep& step) {
    ++reports;
    EXPECT_EQ(level, 0U);
    EXPECT_LE(step.residual, settings.newton.tolerance);
  });
  EXPECT_EQ(result.status, NewtonStatus::converged);
  EXPECT_EQ(result.steps, 1);
  EXPECT_EQ(reports, 1);
  EXPECT_GT(result.iterations, 3);
}

TEST(LinearElastic, loads_scale_the_answer_and_a_state_goes_on) {
  const Body body = make_truth_cube_body(4, false);
  const SolverSettings settings = linear_settings(0.4);
  const auto solver = make_linear_solver(body.levels, body.loading, settings);
  const auto& rest = body.levels[0].rest;
  ASSERT_EQ(solver->solve_to(0.05, {}).status, NewtonStatus::converged);
  const SolverState state = solver->state();
  std::vector<Point> doubled = solver->positions();
  for (std::size_t n = 0; n < doubled.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) doubled[n][k] += doubled[n][k] - rest[n][k];
  }
  ASSERT_EQ(solver->solve_to(0.1, {}).status, NewtonStatus::converged);
  EXPECT_LE(largest_distance(solver->positions(), doubled), 1e-11 * side);
  const auto other = make_linear_solver(body.levels, body.loading, settings);
  other->restore(state);
  EXPECT_EQ(other->load(), 0.05);
  EXPECT_LE(largest_distance(other->positions(), state.positions[0]), 1e-16);
  ASSERT_EQ(other->solve_to(0.1, {}).status, NewtonStatus::converged);
  EXPECT_EQ(largest_distance(solver->positions(), other->positions()), 0);
  EXPECT_THROW(other->restore({0, true, {{Point{}}}}), Error);
  EXPECT_THROW(other->restore({0, true, {}}), Error);
}

TEST(LinearElastic, a_state_whose_numbers_are_not_finite_is_refused_and_changes_nothing) {
  const Body body = make_truth_cube_body(4, false);
  const auto solver = make_linear_solver(body.levels, body.loading, linear_settings(0.4));
  ASSERT_EQ(solver->solve_to(0.05, {}).status, NewtonStatus::converged);
  const SolverState good = solver->state();
  SolverState bad = good;
  bad.load = NAN;
  EXPECT_THROW(solver->restore(bad), Error);
  bad = good;
  bad.positions[0][2][1] = INFINITY;
  EXPECT_THROW(solver->restore(bad), Error);
  EXPECT_EQ(solver->load(), 0.05);
  EXPECT_EQ(solver->positions(), good.positions[0]);
}

TEST(LinearElastic, what_it_cannot_do_is_refused_with_a_reason) {
  const auto refusal = [](const Body& body, const SolverSettings& settings) -> std::string {
    try {
      (void)make_linear_solver(body.levels, body.loading, settings);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const SolverSettings good = linear_settings(0.4);
  EXPECT_EQ(refusal(make_truth_cube_body(2, false), good), "");
  EXPECT_NE(refusal(make_truth_cube_body(2, true), good).find("do not average volumes"), std::string::npos);
  EXPECT_NE(refusal(with_contact(make_truth_cube_body(2, false)), good).find("cannot have rigid planes"),
            std::string::npos);
  EXPECT_NE(refusal({{}, {}}, good).find("a mesh with at least one tet"), std::string::npos);
  SolverSettings settings = good;
  settings.poissons_ratio = 0.5;
  EXPECT_NE(refusal(make_truth_cube_body(2, false), settings).find("linear elasticity"), std::string::npos);
}

}  // namespace
}  // namespace physgen::fem
