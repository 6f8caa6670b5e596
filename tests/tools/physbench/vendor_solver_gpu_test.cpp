// Conjugate gradients over cuSPARSE's product against the solver's own.
#include <fem/solver/hierarchy/hierarchy.h>
#include <fem/solver/levels/scattered.h>
#include <fem/solver/quasistatic.h>
#include <gtest/gtest.h>
#include <physgen/device.h>
#include <physgen/error.h>

#include <cmath>

#include "linear_solves/vendor_solver.h"
#include "vendor/cusparse_product.h"

namespace physgen::bench {
namespace {

using fem::Point;

class VendorSolver : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!cuda_available()) GTEST_SKIP() << "no CUDA device";
    if (const std::string missing = missing_cusparse(); !missing.empty()) GTEST_SKIP() << missing;
    levels_ = fem::make_cube_levels(8, 0.08, true);
    for (fem::MeshLevel& level : levels_) {
      for (std::size_t n = 0; n < level.rest.size(); ++n) {
        level.fixed[n] = level.rest[n][2] == 0 ? 7 : (level.rest[n][2] == 0.08 ? 4 : 0);
      }
    }
    force_.resize(levels_.front().rest.size());
    for (std::size_t n = 0; n < force_.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) force_[n][k] = fem::detail::scattered(static_cast<index_t>(3 * n + k), 1);
    }
  }

  [[nodiscard]] std::unique_ptr<fem::QuasistaticSolver> make(fem::TangentPrecision precision) const {
    fem::SolverSettings settings;
    settings.youngs_modulus = 15e3;
    settings.device = fem::Device::cuda;
    settings.precision = precision;
    settings.newton.preconditioner.kind = fem::Preconditioner::block_jacobi;
    return fem::make_solver(levels_, {std::vector<Point>(force_.size(), Point{}), {}}, settings);
  }
  [[nodiscard]] const std::vector<std::uint8_t>& fixed() const { return levels_.front().fixed; }

  std::vector<fem::MeshLevel> levels_;
  std::vector<Point> force_;
};

double largest_difference(const std::vector<Point>& a, const std::vector<Point>& b) {
  double largest = 0;
  for (std::size_t n = 0; n < a.size(); ++n) {
    largest = std::max(largest, std::hypot(a[n][0] - b[n][0], a[n][1] - b[n][1], a[n][2] - b[n][2]));
  }
  return a.size() == b.size() ? largest : INFINITY;
}

TEST_F(VendorSolver, finds_the_step_that_the_solver_finds) {
  const auto exact = make(fem::TangentPrecision::float64);
  std::vector<Point> expected, step;
  ASSERT_EQ(exact->solve_linear(force_, 1e-10, &expected).status, fem::LinearStatus::converged);
  const auto solver = make(fem::TangentPrecision::float32);
  const fem::AssembledStiffness stiffness = solver->stiffness();
  for (const fem::LinearNorm norm : {fem::LinearNorm::euclidean, fem::LinearNorm::preconditioned}) {
    const fem::LinearTask task{.tolerance = 1e-5, .norm = norm, .repeats = 2};
    const fem::LinearMeasurement own = solver->measure_linear(force_, task, nullptr);
    const VendorMeasurement vendor = solve_by_vendor(stiffness, fixed(), force_, task, &step);
    ASSERT_EQ(vendor.measured.result.status, fem::LinearStatus::converged);
    EXPECT_LE(fem::relative_residual(stiffness, fixed(), force_, step), 5e-5);
    // The same method over the same matrix; sums differ in their order.
    EXPECT_NEAR(vendor.measured.result.iterations, own.result.iterations, 3 + own.result.iterations / 50.0);
    EXPECT_FALSE(vendor.product.empty());
    EXPECT_EQ(vendor.note, "");
    const std::vector<Point> nothing(force_.size(), Point{});
    EXPECT_LE(largest_difference(step, expected), 1e-3 * largest_difference(expected, nothing));
  }
}

TEST_F(VendorSolver, of_no_force_takes_no_step) {
  const auto solver = make(fem::TangentPrecision::float32);
  const std::vector<Point> nothing(force_.size(), Point{});
  std::vector<Point> step;
  const VendorMeasurement vendor = solve_by_vendor(solver->stiffness(), fixed(), nothing, {}, &step);
  EXPECT_EQ(vendor.measured.result.status, fem::LinearStatus::converged);
  EXPECT_EQ(vendor.measured.result.iterations, 0);
  EXPECT_EQ(step, nothing);
}

TEST_F(VendorSolver, refuses_forces_of_another_mesh) {
  const auto solver = make(fem::TangentPrecision::float32);
  const std::vector<Point> fewer(force_.size() - 1);
  EXPECT_THROW((void)solve_by_vendor(solver->stiffness(), fixed(), fewer, {}, nullptr), Error);
}

}  // namespace
}  // namespace physgen::bench
