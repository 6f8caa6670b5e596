// Requirements on the 3x3 SVD of ordinary and hard matrices, written once for SIMD packs, single numbers and CUDA:
// type-parameterised tests, instantiated by svd_test.cpp and svd_gpu_test.cu. parallel_for is included by those files.
#pragma once

#include <elasticity.physgen.h>
#include <fem/kernels/compute_svd.h>
#include <fem/reference/distribution.h>
#include <fem/reference/matrix_families.h>
#include <fem/reference/svd_errors.h>
#include <gtest/gtest.h>
#include <physgen/launch/in_lanes.h>

#include <cstring>
#include <vector>

#include "reference.h"
#include "replay.h"
#include "run_case.h"

namespace physgen::fem {

template <class Case>
class SvdOf : public testing::Test {
 protected:
  using Real = typename Case::Real;
  using Space = typename Case::Space;
  template <class Object, class Where>
  using Array = physgen::Array<Object, Real, Where, typename Case::Layout>;
  static constexpr double eps = std::numeric_limits<Real>::epsilon();

  void SetUp() override {
    if (Space::kind == SpaceKind::cuda && !cuda_available()) GTEST_SKIP() << "no CUDA device here";
  }

  /// Outputs are poisoned with NaN first.
  static std::vector<Svd<Real>> decompose(const std::vector<Matrix3<Real>>& matrices) {
    const auto n = static_cast<index_t>(matrices.size());
    Array<elasticity::DeformationGradientObject, Host> host_gradients(n);
    for (index_t i = 0; i < n; ++i) host_gradients.view()[i].F() = matrices[static_cast<std::size_t>(i)];
    Array<elasticity::DeformationSvdObject, Host> host_svds(n);
    std::memset(static_cast<void*>(host_svds.view().data()), 0xff, static_cast<std::size_t>(host_svds.bytes()));
    Array<elasticity::DeformationGradientObject, Space> gradients(n);
    Array<elasticity::DeformationSvdObject, Space> svds(n);
    copy(gradients, host_gradients);
    copy(svds, host_svds);
    const ComputeSvd kernel{gradients.const_view(), svds.view()};
    if constexpr (Space::kind == SpaceKind::cuda) {
      parallel_for(Space{}, n, kernel);
    } else {
      parallel_for(Space{}, n, lanes<Case::lanes>(kernel));
    }
    copy(host_svds, svds);
    synchronize();
    std::vector<Svd<Real>> result(matrices.size());
    for (index_t i = 0; i < n; ++i) {
      const auto at = host_svds.view()[i];
      result[static_cast<std::size_t>(i)] = {at.U().get(), at.s().get(), at.V().get()};
    }
    return result;
  }
  static std::vector<Matrix3<Real>> members(const reference::MatrixFamily& family, int count,
                                            reference::Random& random) {
    std::vector<Matrix3<Real>> matrices;
    for (int k = 0; k < count; ++k) matrices.push_back(family.make(random).template cast<Real>());
    return matrices;
  }
  static std::vector<Vector3<Real>> values(const std::vector<Matrix3<Real>>& matrices) {
    std::vector<Vector3<Real>> result;
    for (const Svd<Real>& svd : decompose(matrices)) result.push_back(svd.s);
    return result;
  }
  static testing::AssertionResult accepted(const Matrix3<Real>& matrix, const Svd<Real>& svd) {
    const reference::SvdErrors e = reference::svd_errors(matrix, svd);
    if (e.finite && e.residual <= 24 && e.orthogonality <= 32 && e.values <= 16 && e.ordered && e.sign_of_det) {
      return testing::AssertionSuccess();
    }
    const Eigen::IOFormat all(Eigen::FullPrecision, 0, ", ", "; ");
    return testing::AssertionFailure() << (e.finite ? "" : "not finite; ") << "residual " << e.residual
                                       << " eps, orthogonality " << e.orthogonality << " eps, values " << e.values
                                       << " eps" << (e.ordered ? "" : ", not ordered")
                                       << (e.sign_of_det ? "" : ", wrong sign of s3") << "\nA = " << matrix.format(all)
                                       << "\nU = " << svd.U.format(all) << "\ns = " << svd.s.transpose().format(all)
                                       << "\nV = " << svd.V.format(all);
  }
};
TYPED_TEST_SUITE_P(SvdOf);

TYPED_TEST_P(SvdOf, accepts_every_hard_family) {
  using Real = typename TypeParam::Real;
  reference::Random random(2);
  double residual = 0, orthogonality = 0, values = 0;
  Matrix3<Real> worst = Matrix3<Real>::Zero();
  for (const auto& family : reference::hard_matrices(reference::Precision::of<Real>())) {
    SCOPED_TRACE(family.name);
    const auto matrices = TestFixture::members(family, 500, random);
    const auto svds = TestFixture::decompose(matrices);
    for (std::size_t k = 0; k < matrices.size(); ++k) {
      ASSERT_TRUE(TestFixture::accepted(matrices[k], svds[k]));
      const reference::SvdErrors e = reference::svd_errors(matrices[k], svds[k]);
      if (!(e.residual <= residual)) worst = matrices[k];
      residual = std::max(residual, e.residual), orthogonality = std::max(orthogonality, e.orthogonality);
      values = std::max(values, e.values);
    }
  }
  std::cout << "hard families: residual " << residual << " eps, orthogonality " << orthogonality << " eps, values "
            << values << " eps\n"
            << replay_command(worst) << "\n";
}

TYPED_TEST_P(SvdOf, stays_finite_where_singular_values_overflow) {
  using Real = typename TypeParam::Real;
  const Real most = std::numeric_limits<Real>::max();
  reference::Random random(6);
  std::vector<Matrix3<Real>> matrices;
  for (int k = 0; k < 200; ++k) {
    matrices.push_back(Matrix3<Real>::NullaryExpr([&] { return random.integer(0, 1) == 0 ? most : -most; }));
  }
  double largest = 0;
  for (const Svd<Real>& svd : TestFixture::decompose(matrices)) {
    ASSERT_TRUE(svd.s.allFinite() && svd.U.allFinite() && svd.V.allFinite());
    ASSERT_TRUE(svd.s[0] >= svd.s[1] && svd.s[1] >= std::abs(svd.s[2]));
    largest = std::max(largest, static_cast<double>(svd.s[0]));
  }
  EXPECT_EQ(largest, static_cast<double>(most));
}

TYPED_TEST_P(SvdOf, reproduces_two_million_gaussian_matrices_to_nine_eps) {
  reference::Random random(1);
  reference::ErrorDistribution residual, orthogonality;
  Matrix3<typename TypeParam::Real> worst = Matrix3<typename TypeParam::Real>::Zero();
  for (int part = 0; part < 20; ++part) {
    const auto matrices = TestFixture::members(
        {"", [](reference::RandomMatrices& r) -> Eigen::Matrix3d { return r.gaussian(); }}, 100000, random);
    const auto svds = TestFixture::decompose(matrices);
    for (std::size_t k = 0; k < matrices.size(); ++k) {
      const reference::SvdErrors e = reference::svd_residuals(matrices[k], svds[k]);
      if (!(e.residual <= residual.max())) worst = matrices[k];
      residual.add(e.residual);
      orthogonality.add(e.orthogonality);
    }
  }
  for (const auto& [name, errors] : {std::pair{"residual", &residual}, std::pair{"orthogonality", &orthogonality}}) {
    const reference::ErrorSummary e = errors->summary();
    std::cout << name << " [eps]: p50 " << e.p50 << ", p99 " << e.p99 << ", p99.99 " << e.p9999 << ", max " << e.max
              << "\n";
  }
  std::cout << replay_command(worst) << "\n";
  EXPECT_LE(residual.max(), 9);
  EXPECT_LE(orthogonality.max(), 16);
}

TYPED_TEST_P(SvdOf, scales_by_powers_of_two_bit_for_bit) {
  using Real = typename TypeParam::Real;
  reference::Random random(3);
  std::vector<Matrix3<Real>> plain, scaled;
  std::vector<Real> factors;
  const int most = std::numeric_limits<Real>::max_exponent - 40;
  for (int k = 0; k < 2000; ++k) {
    plain.push_back(random.gaussian().template cast<Real>());
    factors.push_back(std::ldexp(Real(1), random.integer(-most, most)));
    scaled.push_back(plain.back() * factors.back());
  }
  const auto s = TestFixture::decompose(plain), t = TestFixture::decompose(scaled);
  for (std::size_t k = 0; k < s.size(); ++k) {
    ASSERT_EQ((s[k].s * factors[k]).eval(), t[k].s);
    ASSERT_EQ(s[k].U, t[k].U);
    ASSERT_EQ(s[k].V, t[k].V);
  }
}

TYPED_TEST_P(SvdOf, gives_the_same_singular_values_for_the_transpose_and_rotated_matrices) {
  using Real = typename TypeParam::Real;
  reference::Random random(4);
  std::vector<Matrix3<Real>> plain, other;
  for (int k = 0; k < 3000; ++k) {
    const Eigen::Matrix3d a = random.gaussian().cast<Real>().template cast<double>();
    plain.push_back(a.cast<Real>());
    const std::array<Eigen::Matrix3d, 3> others{a.transpose(), random.rotation() * a, a * random.rotation()};
    other.push_back(others[static_cast<std::size_t>(k % 3)].cast<Real>());
  }
  const auto s = TestFixture::values(plain), t = TestFixture::values(other);
  for (std::size_t k = 0; k < s.size(); ++k) {
    ASSERT_LE(double((s[k] - t[k]).cwiseAbs().template maxCoeff<Eigen::PropagateNaN>()),
              16 * TestFixture::eps * double(s[k][0]));
  }
}

TYPED_TEST_P(SvdOf, turns_nan_and_infinity_into_nan_everywhere) {
  using Real = typename TypeParam::Real;
  std::vector<Matrix3<Real>> matrices;
  reference::Random random(5);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()}) {
    for (int k = 0; k < 9; ++k) {
      for (const Eigen::Matrix3d& base : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), random.gaussian(),
                                          Eigen::Matrix3d(Eigen::Matrix3d::Zero())}) {
        Matrix3<Real> a = base.cast<Real>();
        a(k % 3, k / 3) = Real(bad);
        matrices.push_back(a);
      }
    }
  }
  const auto svds = TestFixture::decompose(matrices);
  for (std::size_t k = 0; k < svds.size(); ++k) {
    EXPECT_TRUE(svds[k].s.array().isNaN().all()) << "A =\n" << matrices[k] << "\ns = " << svds[k].s.transpose();
    EXPECT_TRUE(svds[k].U.array().isNaN().all()) << "A =\n" << matrices[k] << "\nU =\n" << svds[k].U;
    EXPECT_TRUE(svds[k].V.array().isNaN().all()) << "A =\n" << matrices[k] << "\nV =\n" << svds[k].V;
  }
}

REGISTER_TYPED_TEST_SUITE_P(SvdOf, accepts_every_hard_family, stays_finite_where_singular_values_overflow,
                            reproduces_two_million_gaussian_matrices_to_nine_eps, scales_by_powers_of_two_bit_for_bit,
                            gives_the_same_singular_values_for_the_transpose_and_rotated_matrices,
                            turns_nan_and_infinity_into_nan_everywhere);

}  // namespace physgen::fem
