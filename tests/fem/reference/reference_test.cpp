// The oracles themselves: that they see errors of every kind.
#include "reference.h"

#include <fem/reference/distribution.h>
#include <fem/reference/svd_errors.h>
#include <gtest/gtest.h>

#include <cmath>

#include "replay.h"

namespace physgen::fem {
namespace {

using reference::SvdErrors;

constexpr double infinity = std::numeric_limits<double>::infinity();

// A correct decomposition of a random matrix, with singular values far apart.
struct Example {
  Matrix3<double> A;
  Svd<double> svd;
};
Example example(std::uint64_t stream) {
  reference::Random random(stream);
  const Eigen::Matrix3d U = random.rotation(), V = random.rotation();
  const Eigen::Vector3d s(3, 2, -1);
  return {U * s.asDiagonal() * V.transpose(), {U, s, V}};
}

bool accepted(const SvdErrors& e) {
  return e.finite && e.residual <= 24 && e.orthogonality <= 32 && e.values <= 16 && e.ordered && e.sign_of_det;
}

TEST(SvdErrors, accept_a_correct_decomposition) {
  const Example x = example(1);
  EXPECT_TRUE(accepted(reference::svd_errors(x.A, x.svd)));
}
TEST(SvdErrors, see_a_perturbed_singular_value) {
  Example x = example(2);
  x.svd.s[1] *= 1 + 0x1p-46;  // 64 eps
  const SvdErrors e = reference::svd_errors(x.A, x.svd);
  EXPECT_NEAR(e.values, 64 * 2. / 3, 4);
  EXPECT_GT(e.residual, 24);
}
TEST(SvdErrors, see_a_reflection) {
  Example x = example(3);
  x.svd.U.col(2) = -x.svd.U.col(2);
  x.svd.s[2] = -x.svd.s[2];
  const SvdErrors e = reference::svd_errors(x.A, x.svd);
  EXPECT_LE(e.residual, 24);
  EXPECT_GT(e.orthogonality, 1e15);
  EXPECT_FALSE(e.sign_of_det);
}
TEST(SvdErrors, see_singular_values_out_of_order) {
  Example x = example(4);
  x.svd.U.col(0).swap(x.svd.U.col(1));
  x.svd.V.col(0).swap(x.svd.V.col(1));
  x.svd.U.col(0) = -x.svd.U.col(0).eval();
  x.svd.V.col(0) = -x.svd.V.col(0).eval();
  std::swap(x.svd.s[0], x.svd.s[1]);
  const SvdErrors e = reference::svd_errors(x.A, x.svd);
  EXPECT_LE(e.residual, 24);
  EXPECT_FALSE(e.ordered);
}
TEST(SvdErrors, of_what_is_not_finite_are_infinite) {
  for (int part = 0; part < 3; ++part) {
    Example x = example(5);
    (part == 0 ? x.svd.U(1, 1) : part == 1 ? x.svd.s[0] : x.svd.V(2, 0)) = std::nan("");
    const SvdErrors e = reference::svd_errors(x.A, x.svd);
    EXPECT_FALSE(e.finite);
    EXPECT_EQ(e.residual, infinity);
    EXPECT_EQ(e.orthogonality, infinity);
    EXPECT_EQ(e.values, infinity);
  }
}
TEST(SvdErrors, name_the_command_that_shows_the_matrix_again) {
  Matrix3<float> A = Matrix3<float>::Identity();
  A(1, 0) = -1.5F;
  EXPECT_EQ(replay_command(A),
            "physbench replay svd float 0x1p+0 -0x1.8p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0");
}

TEST(ErrorDistribution, has_percentiles_and_the_index_of_the_worst) {
  reference::ErrorDistribution errors;
  for (int k = 0; k < 10001; ++k) errors.add((k * 7919) % 10001);  // 0 .. 10000 in another order
  EXPECT_EQ(errors.percentile(0.5), 5000);
  EXPECT_EQ(errors.percentile(0.99), 9900);
  EXPECT_EQ(errors.percentile(0.9999), 9999);
  EXPECT_EQ(errors.max(), 10000);
  EXPECT_EQ((errors.worst_index() * 7919) % 10001, 10000);
}
TEST(ErrorDistribution, counts_nan_as_an_infinite_error) {
  reference::ErrorDistribution errors;
  for (const double e : {1., std::nan(""), 2.}) errors.add(e);
  const reference::ErrorSummary summary = errors.summary();
  EXPECT_EQ(summary.max, infinity);
  EXPECT_EQ(summary.worst_index, 1);
  EXPECT_EQ(summary.count, 3);
}
TEST(ErrorDistribution, of_nothing_is_zero) {
  const reference::ErrorSummary summary = reference::ErrorDistribution().summary();
  EXPECT_EQ(summary.count, 0);
  EXPECT_EQ(summary.max, 0);
  EXPECT_EQ(summary.worst_index, -1);
}

}  // namespace
}  // namespace physgen::fem
