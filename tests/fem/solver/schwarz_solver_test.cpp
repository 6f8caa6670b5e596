// The solver with the multilevel Schwarz preconditioner: iterations against block Jacobi, and the states that it finds.
#include <gtest/gtest.h>

#include <cstdio>

#include "bonded.h"

namespace physgen::fem {
namespace {

SolverSettings settings_of(double poissons_ratio, TangentPrecision precision, Preconditioner kind) {
  SolverSettings settings = exact_settings("neo-hookean", poissons_ratio);
  settings.precision = precision;
  settings.nested = false;
  settings.newton.preconditioner.kind = kind;
  return settings;
}

int iterations(const std::vector<MeshLevel>& levels, const SolverSettings& settings, double tolerance) {
  Loading loading;
  loading.motion.assign(levels[0].rest.size(), Point{});
  const auto solver = make_solver(levels, loading, settings);
  std::mt19937_64 random(101);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<Point> forces(levels[0].rest.size());
  for (Point& f : forces) f = {number(random), number(random), number(random)};
  const LinearResult result = solver->solve_linear(forces, tolerance, nullptr);
  EXPECT_EQ(result.status, LinearStatus::converged);
  EXPECT_LE(result.reduction, tolerance);
  return result.iterations;
}

TEST(SchwarzSolver, takes_less_than_half_of_the_iterations_of_block_jacobi) {
  const struct {
    double poissons_ratio;
    bool patches;
    double tolerance;
    int most;  ///< of Schwarz blocks; the first is a twentieth above another program's count
  } rows[] = {{.45, false, 1e-8, 125}, {.49, true, 1e-4, 120}, {.499, true, 1e-4, 400}};
  for (const auto& [poissons_ratio, patches, tolerance, most] : rows) {
    const auto levels = make_truth_cube_body(16, patches).levels;
    const auto count = [&](Preconditioner kind) {
      return iterations(levels, settings_of(poissons_ratio, TangentPrecision::float64, kind), tolerance);
    };
    const int schwarz = count(Preconditioner::schwarz), jacobi = count(Preconditioner::block_jacobi);
    std::printf("nu %g: %d iterations to %g, %d by block Jacobi\n", poissons_ratio, schwarz, tolerance, jacobi);
    EXPECT_LE(2 * schwarz, jacobi) << poissons_ratio;
    EXPECT_LE(schwarz, most) << poissons_ratio;
  }
}

TEST(SchwarzSolver, with_factors_in_half_takes_hardly_more_iterations) {
  for (const double poissons_ratio : {.45, .499}) {
    const auto levels = make_truth_cube_body(16, true).levels;
    const auto count = [&](TangentPrecision precision) {
      return iterations(levels, settings_of(poissons_ratio, precision, Preconditioner::schwarz), 1e-4);
    };
    const int half = count(TangentPrecision::half), whole = count(TangentPrecision::float32);
    std::printf("nu %g: %d in half, %d in float\n", poissons_ratio, half, whole);
    EXPECT_LE(half, whole + whole / 20 + 1) << poissons_ratio;
  }
}

TEST(SchwarzSolver, takes_fewer_iterations_on_a_mesh_alone_whatever_the_order_of_its_nodes) {
  for (const bool patches : {false, true}) {
    const Tets ordered = irregular_box({10, 9, 12}, {0.07, 0.06, 0.08}, 0.2, 103);
    const auto settings = [&](Preconditioner kind) { return settings_of(.45, TangentPrecision::half, kind); };
    const auto levels = bonded(ordered, patches), mixed = bonded(shuffled(ordered, 107), patches);
    const int schwarz = iterations(levels, settings(Preconditioner::schwarz), 1e-4);
    const int of_mixed = iterations(mixed, settings(Preconditioner::schwarz), 1e-4);
    const int jacobi = iterations(levels, settings(Preconditioner::block_jacobi), 1e-4);
    std::printf("%s: %d iterations, %d of nodes in random order, %d by block Jacobi\n", patches ? "patches" : "tets",
                schwarz, of_mixed, jacobi);
    EXPECT_LE(3 * schwarz, 2 * jacobi);
    EXPECT_NEAR(of_mixed, schwarz, 0.15 * schwarz + 2);
  }
}

std::vector<Point> compressed(const std::vector<MeshLevel>& levels, const SolverSettings& settings) {
  const double top = std::ranges::max(levels[0].rest, {}, [](const Point& x) { return x[2]; })[2];
  const Loading loading{
      at_nodes(levels[0].rest, [=](const Point& x) { return x[2] == top ? Point{0, 0, -top} : Point{}; }), {}};
  const auto solver = make_solver(levels, loading, settings);
  for (const double load : {0.05, 0.1}) {
    const NewtonResult result = solver->solve_to(load, {});
    EXPECT_EQ(result.status, NewtonStatus::converged);
    EXPECT_EQ(result.bisections, 0);
  }
  return solver->positions();
}

TEST(SchwarzSolver, finds_the_state_that_multigrid_finds_in_every_precision_nested_and_not) {
  for (const bool patches : {false, true}) {
    for (const bool frictionless : {false, true}) {
      const auto levels = make_truth_cube_body(8, patches, frictionless).levels;
      const auto expected = compressed(levels, settings_of(.49, TangentPrecision::float64, Preconditioner::multigrid));
      for (const TangentPrecision precision :
           {TangentPrecision::half, TangentPrecision::float32, TangentPrecision::float64}) {
        for (const bool nested : {false, true}) {
          SolverSettings settings = settings_of(.49, precision, Preconditioner::schwarz);
          settings.nested = nested;
          settings.newton.tolerance = 1e-9;
          EXPECT_LE(largest_distance(compressed(levels, settings), expected), 1e-9) << patches << frictionless;
        }
      }
    }
  }
}

TEST(SchwarzSolver, finds_the_state_of_a_mesh_alone_that_block_jacobi_finds) {
  for (const bool patches : {false, true}) {
    const auto levels = bonded(shuffled(irregular_box({6, 5, 7}, {0.05, 0.06, 0.08}, 0.2, 109), 113), patches);
    const auto found = [&](Preconditioner kind) {
      SolverSettings settings = settings_of(.49, TangentPrecision::half, kind);
      settings.newton.tolerance = 1e-9;
      return compressed(levels, settings);
    };
    EXPECT_LE(largest_distance(found(Preconditioner::schwarz), found(Preconditioner::block_jacobi)), 1e-9) << patches;
  }
}

TEST(SchwarzSolver, returns_a_body_to_rest_that_nothing_holds) {
  const Body body = make_cube(
      4, 0.08, false, 0, [](const Point&) -> std::uint8_t { return 0; }, [](const Point&) { return Point{}; });
  SolverSettings settings = settings_of(.45, TangentPrecision::float64, Preconditioner::schwarz);
  settings.newton.tolerance = 1e-9;
  const auto solver = make_solver(body.levels, body.loading, settings);
  std::mt19937_64 random(127);
  std::uniform_real_distribution<double> part(-0.004, 0.004);
  std::vector<Point> positions = body.levels[0].rest;
  for (Point& x : positions) {
    for (double& number : x) number += part(random);
  }
  solver->set_positions(positions);
  const NewtonResult result = solver->solve_to(0, {});
  EXPECT_EQ(result.status, NewtonStatus::converged);
  EXPECT_LE(result.energy, 1e-12);
  EXPECT_GT(result.smallest_J, 0.999);
}

}  // namespace
}  // namespace physgen::fem
