// Clamped and absolute eigenvalues of matrices of many kinds, against an eigendecomposition in extended precision.
#include <functional>

#include "definiteness_checks.h"

namespace physgen::fem {
namespace {

using Eigen::Matrix3d;

struct Kind {
  const char* name;
  std::function<Matrix3d(Random&)> make;
};

Matrix3d with_eigenvalues(Random& r, double a, double b, double c) {
  const Matrix3d Q = r.rotation();
  return Q * Eigen::Vector3d(a, b, c).asDiagonal() * Q.transpose();
}

Matrix3d with_random_eigenvalues(Random& r) {
  const double a = r.normal(), b = r.normal(), c = r.normal();
  return with_eigenvalues(r, a, b, c);
}

// Each draw is a statement of its own: the order of arguments is the compiler's choice, and a seed would not repeat.
const std::vector<Kind>& kinds() {
  static const std::vector<Kind> list{
      {"Gaussian", [](Random& r) { return Matrix3d(r.gaussian().selfadjointView<Eigen::Lower>()); }},
      {"random eigenvalues", [](Random& r) { return with_random_eigenvalues(r); }},
      {"all equal", [](Random& r) { return with_eigenvalues(r, 1, 1, 1); }},
      {"two equal", [](Random& r) { return with_eigenvalues(r, 1, 1, -1); }},
      {"two nearly equal", [](Random& r) { return with_eigenvalues(r, 1, 1 + 1e-7 * r.normal(), -0.5); }},
      {"opposite", [](Random& r) { return with_eigenvalues(r, 1, -1, 1e-3 * r.normal()); }},
      {"rank 1", [](Random& r) { return with_eigenvalues(r, r.normal(), 0, 0); }},
      {"rank 2",
       [](Random& r) {
         const double a = r.normal(), b = r.normal();
         return with_eigenvalues(r, a, b, 0);
       }},
      {"of all magnitudes",
       [](Random& r) {
         const auto value = [&r] { return std::pow(10, r.uniform(-9, 0)) * (r.normal() < 0 ? -1 : 1); };
         const double a = value(), b = value(), c = value();
         return with_eigenvalues(r, a, b, c);
       }},
      {"equal axes",
       [](Random& r) {
         const double a = r.normal(), b = r.normal();
         return Matrix3d(Matrix3d::Constant(b) + (a - b) * Matrix3d::Identity());
       }},
      {"one off-diagonal entry",
       [](Random& r) {
         Matrix3d H = Eigen::Vector3d(1, 1, r.normal()).asDiagonal();
         H(1, 0) = H(0, 1) = r.normal();
         return H;
       }},
      {"diagonal",
       [](Random& r) {
         const double a = r.normal(), b = r.normal(), c = r.normal();
         return Matrix3d(Eigen::Vector3d(a, b, c).asDiagonal());
       }},
      {"huge", [](Random& r) { return Matrix3d(1e30 * with_random_eigenvalues(r)); }},
      {"tiny", [](Random& r) { return Matrix3d(1e-30 * with_random_eigenvalues(r)); }},
  };
  return list;
}

template <class Real>
class Definiteness : public testing::Test {
 protected:
  static constexpr double eps = std::numeric_limits<Real>::epsilon();
  static int count() { return std::getenv("PHYSGEN_TEST_BLOCK") == nullptr ? 20000 : 1; }
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Definiteness, Reals);

TYPED_TEST(Definiteness, filters_the_3x3_block_to_8_eps_whatever_its_eigenvalues) {
  Random random(21);
  for (const Kind& kind : kinds()) {
    ErrorDistribution clamped, absolute, negative;
    WorstInput<6> worst;
    for (int k = 0; k < this->count(); ++k) {
      auto d = derivative_of<TypeParam>(kind.make(random));
      if (const auto given = replayed<6>("PHYSGEN_TEST_BLOCK")) d = derivative_of<TypeParam>(*given);
      const FilterErrors e = filter_errors(d);
      clamped.add(e.clamped), absolute.add(e.absolute), negative.add(e.negative);
      worst.add(std::isnan(e.largest()) ? std::numeric_limits<double>::infinity() : e.largest(), block_entries(d));
    }
    const auto c = clamped.summary();
    std::printf(
        "%-22s %s: clamp p50 %.2f p99 %.2f p99.99 %.2f max %.2f eps |H|, absolute max %.2f, negative %.2f; %s\n",
        kind.name, sizeof(TypeParam) == 4 ? "float " : "double", c.p50, c.p99, c.p9999, c.max, absolute.max(),
        negative.max(), worst.replay("PHYSGEN_TEST_BLOCK").c_str());
    EXPECT_LE(c.max, 8) << kind.name;
    EXPECT_LE(absolute.max(), 8) << kind.name;
    EXPECT_LE(negative.max(), 8) << kind.name;
  }
}

TYPED_TEST(Definiteness, filters_a_filtered_derivative_into_itself) {
  Random random(22);
  for (const Kind& kind : kinds()) {
    for (int k = 0; k < 1000; ++k) {
      const auto once = ClampEigenvalues{}(derivative_of<TypeParam>(kind.make(random)));
      const auto unit = static_cast<TypeParam>(block(once).norm()) * std::numeric_limits<TypeParam>::epsilon();
      for (const auto& twice : {ClampEigenvalues{}(once), AbsoluteEigenvalues{}(once)}) {
        const auto a = entries(once), b = entries(twice);
        for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(a[i], b[i], 16 * unit) << kind.name;
        for (std::size_t i = 6; i < 12; ++i) EXPECT_EQ(a[i], b[i]);
      }
    }
  }
}

TYPED_TEST(Definiteness, of_the_pairs_is_exact) {
  const auto d = derivative_of<TypeParam>(Matrix3d::Identity());  // D 1 -2 0, S -0.5 3 -1
  const auto clamped = entries(ClampEigenvalues{}(d)), absolute = entries(AbsoluteEigenvalues{}(d));
  const std::array<TypeParam, 6> expected_clamped{1, 0, 0, 0, 3, 0};
  const std::array<TypeParam, 6> expected_absolute{1, 2, 0, TypeParam(0.5), 3, 1};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(clamped[6 + i], expected_clamped[i]);
    EXPECT_EQ(absolute[6 + i], expected_absolute[i]);
  }
  const auto kept = entries(Unfiltered{}(d)), given = entries(d);
  for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(kept[i], given[i]);
}

TYPED_TEST(Definiteness, keeps_zero_and_nearly_keeps_diagonal_blocks) {
  const auto zero = entries(ClampEigenvalues{}(derivative_of<TypeParam>(Matrix3d::Zero())));
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(zero[i], 0);
  for (const double size : {1e-30, 1., 3., 1e30}) {
    const auto d =
        entries(ClampEigenvalues{}(derivative_of<TypeParam>(size * Matrix3d(Eigen::Vector3d(1, -2, 3).asDiagonal()))));
    EXPECT_NEAR(d[0] / size, 1, 4 * this->eps);
    EXPECT_NEAR(d[3] / size, 0, 0);
    EXPECT_NEAR(d[5] / size, 3, 12 * this->eps);
    for (const std::size_t off : {1U, 2U, 4U}) EXPECT_EQ(d[off], 0);
  }
}

TYPED_TEST(Definiteness, of_nan_and_infinity_is_not_finite) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity}) {
    for (int k = 0; k < 6; ++k) {
      Matrix3d H;
      H << 2, 0.5, 0.25, 0.5, 1, -0.5, 0.25, -0.5, -1;
      const int r = k < 3 ? k : (k == 5 ? 1 : k - 2), c = k < 3 ? k : (k == 5 ? 2 : 0);
      H(r, c) = H(c, r) = bad;
      const auto clamped = block(ClampEigenvalues{}(derivative_of<TypeParam>(H)));
      const auto absolute = block(AbsoluteEigenvalues{}(derivative_of<TypeParam>(H)));
      EXPECT_FALSE(clamped.allFinite()) << bad << " in " << r << c;
      EXPECT_FALSE(absolute.allFinite()) << bad << " in " << r << c;
    }
    auto d = derivative_of<TypeParam>(Matrix3d::Identity());
    d.d31 = static_cast<TypeParam>(nan);
    EXPECT_TRUE(std::isnan(ClampEigenvalues{}(d).d31));
    EXPECT_TRUE(std::isnan(AbsoluteEigenvalues{}(d).d31));
  }
}

// Not bit for bit: packs of float find roots by Newton's method.
TYPED_TEST(Definiteness, of_packs_is_that_of_numbers_to_16_eps) {
  using B = Batch<TypeParam>;
  Random random(23);
  ErrorDistribution differences;
  for (int k = 0; k < 1000; ++k) {
    const auto d = derivative_of<TypeParam>(kinds()[std::size_t(k) % kinds().size()].make(random));
    const auto e = entries(d);
    const PrincipalDerivative<B> packed{B(e[0]), B(e[1]), B(e[2]), B(e[3]), B(e[4]),  B(e[5]),
                                        B(e[6]), B(e[7]), B(e[8]), B(e[9]), B(e[10]), B(e[11])};
    const auto one = entries(ClampEigenvalues{}(d));
    const auto many = entries(ClampEigenvalues{}(packed));
    // Their estimates of 1 / sqrt differ, and with them a rotation's last digits: each is within 8 eps of the truth.
    const double unit = static_cast<double>(block(d).norm()) * this->eps;
    for (std::size_t i = 0; i < 6; ++i) differences.add(std::abs(double(one[i]) - double(many[i].get(0))) / unit);
    for (std::size_t i = 6; i < 12; ++i) EXPECT_EQ(one[i], many[i].get(0)) << i;
  }
  std::printf("packs and numbers differ by up to %.2f eps |H|\n", differences.max());
  EXPECT_LE(differences.max(), 16);
}

}  // namespace
}  // namespace physgen::fem
