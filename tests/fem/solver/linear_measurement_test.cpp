// The assembled stiffness as users get it, and linear solves that are measured by it.
#include <fem/solver/levels/scattered.h>
#include <gtest/gtest.h>
#include <physgen/error.h>

#include "bodies.h"

namespace physgen::fem {
namespace {

std::vector<Point> scattered_vectors(std::size_t nodes, int seed) {
  std::vector<Point> vectors(nodes);
  for (std::size_t n = 0; n < nodes; ++n) {
    for (std::size_t k = 0; k < 3; ++k) vectors[n][k] = detail::scattered(index_t(3 * n + k), seed);
  }
  return vectors;
}

double largest_norm(const std::vector<Point>& vectors) {
  double most = 0;
  for (const Point& v : vectors) most = std::max(most, std::hypot(v[0], v[1], v[2]));
  return most;
}

/// A solver of the Truth Cube at a compression of a tenth.
std::unique_ptr<QuasistaticSolver> compressed(const Body& body, TangentPrecision precision, Preconditioner kind) {
  SolverSettings settings = exact_settings("neo-hookean", 0.49);
  settings.precision = precision;
  settings.newton.tolerance = 1e-8;
  settings.newton.preconditioner.kind = kind;
  auto solver = make_solver(body.levels, body.loading, settings);
  EXPECT_EQ(solver->solve_to(0.1, {}).status, NewtonStatus::converged);
  return solver;
}

TEST(AssembledStiffness, times_a_displacement_is_the_change_of_the_forces) {
  for (const bool patches : {false, true}) {
    const Body body = make_truth_cube_body(4, patches);
    const auto solver = compressed(body, TangentPrecision::float64, Preconditioner::multigrid);
    const AssembledStiffness stiffness = solver->stiffness();
    const auto at = solver->positions();
    const auto direction = scattered_vectors(at.size(), 3);
    const auto forces_at = [&](double length) {
      std::vector<Point> moved = at;
      for (std::size_t n = 0; n < at.size(); ++n) {
        for (std::size_t k = 0; k < 3; ++k) moved[n][k] += length * direction[n][k];
      }
      solver->set_positions(moved);
      return solver->forces();
    };
    constexpr double length = 1e-6;  // [m]; cells have 0.02
    const auto up = forces_at(length), down = forces_at(-length);
    std::vector<Point> change(at.size());
    for (std::size_t n = 0; n < at.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) change[n][k] = (up[n][k] - down[n][k]) / (2 * length);
    }
    EXPECT_LE(largest_distance(stiffness.product(direction), change), 1e-6 * largest_norm(change)) << patches;
  }
}

TEST(AssembledStiffness, of_float_and_half_is_that_of_double_to_the_precision_of_float) {
  const Body body = make_truth_cube_body(4, true);
  const auto exact = compressed(body, TangentPrecision::float64, Preconditioner::multigrid);
  const AssembledStiffness expected = exact->stiffness();
  const auto direction = scattered_vectors(body.levels[0].rest.size(), 3);
  const auto product = expected.product(direction);
  for (const TangentPrecision precision : {TangentPrecision::half, TangentPrecision::float32}) {
    const auto solver = compressed(body, precision, Preconditioner::multigrid);
    solver->set_positions(exact->positions());
    const AssembledStiffness stiffness = solver->stiffness();
    EXPECT_EQ(stiffness.edges, expected.edges);
    const double error = largest_distance(stiffness.product(direction), product);
    EXPECT_GT(error, 0);
    EXPECT_LE(error, 1e-5 * largest_norm(product));
  }
}

TEST(AssembledStiffness, refuses_vectors_of_other_sizes) {
  const Body body = make_truth_cube_body(2, false);
  const auto solver = compressed(body, TangentPrecision::float64, Preconditioner::block_jacobi);
  const AssembledStiffness stiffness = solver->stiffness();
  const std::vector<Point> vectors(stiffness.nodes.size()), fewer(stiffness.nodes.size() - 1);
  const auto& fixed = body.levels[0].fixed;
  EXPECT_THROW((void)stiffness.product(fewer), Error);
  EXPECT_THROW((void)relative_residual(stiffness, fixed, fewer, vectors), Error);
  EXPECT_THROW((void)relative_residual(stiffness, {}, vectors, vectors), Error);
}

TEST(RelativeResidual, is_one_without_a_step_and_takes_free_components_alone) {
  const Body body = make_truth_cube_body(4, false);
  const auto solver = compressed(body, TangentPrecision::float64, Preconditioner::multigrid);
  const AssembledStiffness stiffness = solver->stiffness();
  const std::vector<Point> nothing(stiffness.nodes.size(), Point{});
  const auto& fixed = body.levels[0].fixed;
  auto force = scattered_vectors(nothing.size(), 1);
  EXPECT_EQ(relative_residual(stiffness, fixed, force, nothing), 1);
  EXPECT_EQ(relative_residual(stiffness, fixed, nothing, nothing), 0);
  std::vector<Point> step;
  ASSERT_EQ(solver->solve_linear(force, 1e-12, &step).status, LinearStatus::converged);
  EXPECT_LE(relative_residual(stiffness, fixed, force, step), 1e-11);
  for (std::size_t n = 0; n < force.size(); ++n) {
    if (fixed[n] == 7) force[n] = {1e9, 1e9, 1e9};
  }
  EXPECT_LE(relative_residual(stiffness, fixed, force, step), 1e-11);
}

TEST(LinearMeasurement, in_the_euclidean_norm_all_preconditioners_end_at_the_residual_that_is_asked_for) {
  const Body body = make_truth_cube_body(8, true);
  const auto force = scattered_vectors(body.levels[0].rest.size(), 1);
  for (const Preconditioner kind :
       {Preconditioner::multigrid, Preconditioner::schwarz, Preconditioner::block_jacobi, Preconditioner::none}) {
    const auto solver = compressed(body, TangentPrecision::float64, kind);
    const AssembledStiffness stiffness = solver->stiffness();
    int before = 0;
    for (const double tolerance : {1e-2, 1e-4, 1e-8}) {
      std::vector<Point> step;
      const auto measured =
          solver->measure_linear(force, {.tolerance = tolerance, .norm = LinearNorm::euclidean}, &step);
      EXPECT_EQ(measured.result.status, LinearStatus::converged);
      EXPECT_GT(measured.result.iterations, before);
      before = measured.result.iterations;
      const double residual = relative_residual(stiffness, body.levels[0].fixed, force, step);
      EXPECT_LE(residual, tolerance * (1 + 1e-6));
      EXPECT_GE(residual, 0.01 * tolerance);  // and not far below, as by another norm
    }
  }
}

TEST(LinearMeasurement, that_is_repeated_finds_the_same_step) {
  const Body body = make_truth_cube_body(4, true);
  const auto force = scattered_vectors(body.levels[0].rest.size(), 1);
  const auto solver = compressed(body, TangentPrecision::half, Preconditioner::multigrid);
  std::vector<Point> once, often;
  const LinearMeasurement single = solver->measure_linear(force, {}, &once);
  const LinearMeasurement repeated = solver->measure_linear(force, {.repeats = 3}, &often);
  EXPECT_EQ(once, often);
  EXPECT_EQ(single.result.iterations, repeated.result.iterations);
  EXPECT_EQ(single.solve_seconds, 0);
  EXPECT_GT(repeated.solve_seconds, 0);
  EXPECT_GT(repeated.product_seconds, 0);
}

TEST(LinearMeasurement, counts_the_bytes_of_arrays_that_kernels_read_and_write) {
  const Body body = make_truth_cube_body(4, false);
  const auto force = scattered_vectors(body.levels[0].rest.size(), 1);
  const auto iteration_bytes = [&](Preconditioner kind) {
    const auto solver = compressed(body, TangentPrecision::float64, kind);
    const LinearMeasurement measured = solver->measure_linear(force, {.repeats = 1}, nullptr);
    const auto nodes = index_t(body.levels[0].rest.size());
    const auto edges = index_t(solver->stiffness().edges.size());
    // Blocks of six and nine doubles, an edge's two names, and vectors of three doubles that are padded to 32 bytes.
    EXPECT_EQ(measured.product_bytes, nodes * (48 + 2 * 32) + edges * (72 + 8));
    EXPECT_GT(measured.iteration_bytes, measured.product_bytes);
    return measured.iteration_bytes;
  };
  const index_t none = iteration_bytes(Preconditioner::none);
  const auto nodes = index_t(body.levels[0].rest.size());
  EXPECT_EQ(iteration_bytes(Preconditioner::block_jacobi) - none, nodes * 48);  // the blocks' inverses
  EXPECT_GT(iteration_bytes(Preconditioner::multigrid), 3 * none);
}

}  // namespace
}  // namespace physgen::fem
