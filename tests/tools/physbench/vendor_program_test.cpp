// The vendor's method on the CPU, over a product of block sparse rows that is written out here.
#include "linear_solves/vendor_program.h"

#include <fem/solver/hierarchy/hierarchy.h>
#include <fem/solver/levels/scattered.h>
#include <fem/solver/linear/product_host.h>
#include <fem/solver/quasistatic.h>
#include <gtest/gtest.h>
#include <physgen/executor.h>

#include <cmath>

#include "vendor/block_matrix.h"

namespace physgen::bench {
namespace {

using fem::Point;

/// As CusparseProduct, in one thread.
class HostProduct {
 public:
  HostProduct(BlockMatrix matrix, const float* x, float* y) : matrix_(std::move(matrix)), x_(x), y_(y) {}
  void run() {
    for (std::size_t row = 0; row + 1 < matrix_.begin.size(); ++row) {
      std::array<float, 3> sum{};
      for (int b = matrix_.begin[row]; b < matrix_.begin[row + 1]; ++b) {
        const auto at = static_cast<std::size_t>(b);
        const float* x = x_ + 3 * matrix_.columns[at];
        for (std::size_t r = 0; r < 3; ++r) {
          for (std::size_t c = 0; c < 3; ++c) sum[r] += matrix_.blocks[9 * at + 3 * r + c] * x[c];
        }
      }
      for (std::size_t r = 0; r < 3; ++r) y_[3 * row + r] = sum[r];
    }
  }
  [[nodiscard]] static std::string name() { return "by hand"; }
  [[nodiscard]] static index_t bytes() { return 1000; }
  static void forget_error() {}
  double seconds = 0;

 private:
  BlockMatrix matrix_;
  const float* x_;
  float* y_;
};

struct Scene {
  std::vector<fem::MeshLevel> levels = fem::make_cube_levels(8, 0.08, true);
  std::vector<Point> force;

  Scene() : force(levels.front().rest.size()) {
    for (fem::MeshLevel& level : levels) {
      for (std::size_t n = 0; n < level.rest.size(); ++n) {
        level.fixed[n] = level.rest[n][2] == 0 ? 7 : (level.rest[n][2] == 0.08 ? 4 : 0);
      }
    }
    for (std::size_t n = 0; n < force.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) force[n][k] = fem::detail::scattered(static_cast<index_t>(3 * n + k), 1);
    }
  }
  [[nodiscard]] std::unique_ptr<fem::QuasistaticSolver> solver(
      fem::TangentPrecision precision = fem::TangentPrecision::float32) const {
    fem::SolverSettings settings;
    settings.youngs_modulus = 15e3;
    settings.precision = precision;
    settings.newton.preconditioner.kind = fem::Preconditioner::block_jacobi;
    return fem::make_solver(levels, {std::vector<Point>(force.size(), Point{}), {}}, settings);
  }
  [[nodiscard]] const std::vector<std::uint8_t>& fixed() const { return levels.front().fixed; }

  VendorMeasurement solve(const fem::AssembledStiffness& stiffness, const fem::LinearTask& task,
                          std::vector<Point>& step) const {
    HostExecutor on;
    VendorProgram<HostExecutor, HostProduct> program(
        on, stiffness, fixed(), force, [&](const float* x, float* y, Stream /*stream*/) {
          return std::make_unique<HostProduct>(make_block_matrix(stiffness, fixed(), BlockOrder::by_rows), x, y);
        });
    VendorMeasurement measurement = program.measure(task);
    program.read_step(step);
    return measurement;
  }
};

TEST(VendorProgram, takes_the_iterations_of_the_solvers_block_jacobi_to_the_same_step) {
  const Scene scene;
  const auto solver = scene.solver();
  const fem::AssembledStiffness stiffness = solver->stiffness();
  for (const fem::LinearNorm norm : {fem::LinearNorm::euclidean, fem::LinearNorm::preconditioned}) {
    for (const double tolerance : {1e-2, 1e-4}) {
      const fem::LinearTask task{.tolerance = tolerance, .norm = norm, .repeats = 1};
      std::vector<Point> own_step, step;
      const fem::LinearMeasurement own = solver->measure_linear(scene.force, task, &own_step);
      const VendorMeasurement vendor = scene.solve(stiffness, task, step);
      EXPECT_EQ(vendor.measured.result.status, fem::LinearStatus::converged);
      EXPECT_NEAR(vendor.measured.result.iterations, own.result.iterations, 2);
      EXPECT_NEAR(vendor.measured.result.reduction / own.result.reduction, 1, 0.1);
      double difference = 0, largest = 0;
      for (std::size_t n = 0; n < step.size(); ++n) {
        for (std::size_t k = 0; k < 3; ++k) {
          difference = std::max(difference, std::abs(step[n][k] - own_step[n][k]));
          largest = std::max(largest, std::abs(own_step[n][k]));
        }
      }
      ASSERT_GT(largest, 0);
      EXPECT_LE(difference, tolerance * largest);
    }
  }
}

TEST(VendorProgram, ends_at_the_residual_that_is_asked_for_and_leaves_prescribed_components) {
  const Scene scene;
  const fem::AssembledStiffness stiffness = scene.solver()->stiffness();
  std::vector<Point> step;
  const fem::LinearTask task{.tolerance = 1e-3, .norm = fem::LinearNorm::euclidean};
  const VendorMeasurement vendor = scene.solve(stiffness, task, step);
  const double residual = fem::relative_residual(stiffness, scene.fixed(), scene.force, step);
  EXPECT_LE(residual, 1.01e-3);
  EXPECT_GE(residual, 1e-4);
  EXPECT_EQ(vendor.product, "by hand");
  EXPECT_EQ(vendor.note, "");
  for (std::size_t n = 0; n < step.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) {
      if ((scene.fixed()[n] >> k & 1) != 0) {
        EXPECT_EQ(step[n][k], 0);
      }
    }
  }
}

TEST(VendorProgram, finds_the_step_that_the_solver_finds_in_double) {
  const Scene scene;
  const auto largest_difference = [](const std::vector<Point>& a, const std::vector<Point>& b) {
    double largest = 0;
    for (std::size_t n = 0; n < a.size(); ++n) {
      largest = std::max(largest, std::hypot(a[n][0] - b[n][0], a[n][1] - b[n][1], a[n][2] - b[n][2]));
    }
    return largest;
  };
  std::vector<Point> expected, step;
  const auto exact = scene.solver(fem::TangentPrecision::float64);
  ASSERT_EQ(exact->solve_linear(scene.force, 1e-10, &expected).status, fem::LinearStatus::converged);
  for (const fem::LinearNorm norm : {fem::LinearNorm::euclidean, fem::LinearNorm::preconditioned}) {
    (void)scene.solve(scene.solver()->stiffness(), {.tolerance = 1e-5, .norm = norm}, step);
    const std::vector<Point> nothing(step.size(), Point{});
    EXPECT_LE(largest_difference(step, expected), 1e-3 * largest_difference(expected, nothing));
  }
}

TEST(VendorProgram, counts_the_bytes_of_the_product_and_of_its_three_kernels) {
  const Scene scene;
  std::vector<Point> step;
  const VendorMeasurement vendor = scene.solve(scene.solver()->stiffness(), {.tolerance = 1e-2}, step);
  // Each node has z and p; p and K p; p, K p, dx, r, z and the inverse of the block. The rest are single numbers.
  const auto nodes = static_cast<index_t>(step.size());
  const index_t rest = vendor.measured.iteration_bytes - vendor.measured.product_bytes - nodes * (9 * 12 + 24);
  EXPECT_EQ(vendor.measured.product_bytes, 1000);
  EXPECT_GE(rest, 0);
  EXPECT_LE(rest, 200);
}

}  // namespace
}  // namespace physgen::bench
