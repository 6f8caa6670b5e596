// The 3x3 SVD on ordinary and hard matrices, as packs and as single numbers, against extended precision.
#include <fem/svd.h>
#include <gtest/gtest.h>
#include <physgen/simd.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "reference.h"

namespace physgen::fem {
namespace {

using reference::Random;
using Long3 = Eigen::Matrix<long double, 3, 3>;

// Worst errors in eps over a family of matrices.
struct Errors {
  double residual = 0, orthogonality = 0, values = 0;
  int unordered = 0, wrong_sign = 0, not_finite = 0;

  template <class T>
  void add(const Matrix3<T>& a, const Svd<T>& r) {
    if (!r.U.allFinite() || !r.V.allFinite() || !r.s.allFinite()) {
      ++not_finite;
      return;
    }
    const long double eps = std::numeric_limits<T>::epsilon();
    const long double slack = std::numeric_limits<T>::denorm_min();
    const Long3 A = a.template cast<long double>(), U = r.U.template cast<long double>(),
                V = r.V.template cast<long double>();
    const Eigen::Matrix<long double, 3, 1> s = r.s.template cast<long double>();
    const long double norm = A.norm(), unit = norm > 0 ? 1 / norm : 1;
    const auto raise = [](double& worst, long double value) { worst = std::max(worst, static_cast<double>(value)); };
    raise(residual, std::max(0.L, (U * s.asDiagonal() * V.transpose() - A).norm() - 4 * slack) * unit / eps);
    for (const Long3& q : {U, V}) {
      raise(orthogonality, (q.transpose() * q - Long3::Identity()).cwiseAbs().maxCoeff() / eps);
      raise(orthogonality, std::abs(q.determinant() - 1) / eps);
    }
    const Eigen::JacobiSVD<Long3> exact(A * unit);
    for (int k = 0; k < 3; ++k) {
      const long double error = std::abs(std::abs(s[k] * unit) - exact.singularValues()[k]) - 4 * slack * unit;
      raise(values, error / eps / std::max(exact.singularValues()[0], 1e-30L));
    }
    if (!(s[0] >= s[1] && s[1] >= std::abs(s[2]))) ++unordered;
    const long double det = (A * unit).determinant();
    if (std::abs(det) > 32 * eps && (det < 0) != std::signbit(s[2])) ++wrong_sign;
  }
};

using Make = std::function<Eigen::Matrix3d(Random&)>;

template <class T>
Errors errors_of(const Make& make, int count, Random& random) {
  using B = Batch<T>;
  constexpr std::size_t W = B::size;
  Errors errors;
  for (int done = 0; done < count; done += static_cast<int>(W)) {
    alignas(64) std::array<std::array<T, W>, 9> in;
    std::array<Matrix3<T>, W> matrices;
    for (std::size_t l = 0; l < W; ++l) {
      matrices[l] = make(random).template cast<T>();
      for (std::size_t k = 0; k < 9; ++k) in[k][l] = matrices[l].data()[k];
    }
    Matrix3<B> packed;
    for (std::size_t k = 0; k < 9; ++k) packed.data()[k] = B::load_aligned(in[k].data());
    const Svd<B> result = svd(packed);
    for (std::size_t l = 0; l < W; ++l) {
      Svd<T> one;
      for (int k = 0; k < 9; ++k)
        one.U.data()[k] = result.U.data()[k].get(l), one.V.data()[k] = result.V.data()[k].get(l);
      for (int k = 0; k < 3; ++k) one.s[k] = result.s[k].get(l);
      errors.add(matrices[l], one);
    }
    errors.add(matrices[0], svd(matrices[0]));
  }
  return errors;
}

Make with_values(double a, double b, double c) {
  return [=](Random& r) -> Eigen::Matrix3d {
    return r.rotation() * Eigen::Vector3d(a, b, c).asDiagonal() * r.rotation().transpose();
  };
}

Make gaussian_times(double factor) {
  return [=](Random& r) -> Eigen::Matrix3d { return factor * r.gaussian().cwiseMax(-1.5).cwiseMin(1.5); };
}

struct Family {
  std::string name;
  Make make;
};

std::vector<Family> hard_families() {
  using M = Eigen::Matrix3d;
  std::vector<Family> f{
      {"zero", [](Random&) -> M { return M::Zero(); }},
      {"identity", [](Random&) -> M { return M::Identity(); }},
      {"minus identity", [](Random&) -> M { return -M::Identity(); }},
      {"rotation", [](Random& r) -> M { return r.rotation(); }},
      {"reflection", [](Random& r) -> M { return -r.rotation(); }},
      {"near rest", [](Random& r) -> M { return M::Identity() + 1e-4 * r.gaussian(); }},
      {"equal columns",
       [](Random& r) -> M {
         M m = r.gaussian();
         m.col(2) = m.col(1);
         return m;
       }},
      {"zero column",
       [](Random& r) -> M {
         M m = r.gaussian();
         m.col(r.integer(0, 2)).setZero();
         return m;
       }},
      {"zero row",
       [](Random& r) -> M {
         M m = r.gaussian();
         m.row(r.integer(0, 2)).setZero();
         return m;
       }},
      {"rank 1 of integers",
       [](Random& r) -> M {
         Eigen::Vector3d a, b;
         for (int k = 0; k < 3; ++k) a[k] = r.integer(-3, 3), b[k] = r.integer(-3, 3);
         return a * b.transpose();
       }},
      {"-1, 0, 1", [](Random& r) -> M { return M::NullaryExpr([&r] { return double(r.integer(-1, 1)); }); }},
      {"skew-symmetric",
       [](Random& r) -> M {
         const M m = r.gaussian();
         return m - m.transpose();
       }},
      {"graded",
       [](Random& r) -> M { return M::NullaryExpr([&r] { return r.normal() * std::pow(10., -r.integer(0, 30)); }); }},
      {"sliver",
       [](Random& r) -> M {
         M m = r.gaussian().triangularView<Eigen::Upper>();
         m(1, 1) *= 1e-3, m(2, 2) *= 1e-6;
         return m;
       }},
  };
  const double ulp = 0x1p-23;
  for (const auto& s : std::vector<std::array<double, 3>>{{2, 1, 1},
                                                          {2, 2, 1},
                                                          {2, 1, -1},
                                                          {1, 0, 0},
                                                          {1, 1, 0},
                                                          {1, 0.5, 0},
                                                          {1, 1, 1e-7},
                                                          {1, 1e-7, 1e-7},
                                                          {1, 1e-3, 1e-6},
                                                          {1, 1e-6, 1e-12},
                                                          {1, 1e-10, 1e-20},
                                                          {1, 1 - ulp, 0.5},
                                                          {1, 1 - 10 * ulp, 1 - 1000 * ulp},
                                                          {1, 0.5, -0.5 + ulp}}) {
    f.push_back({"s = " + std::to_string(s[0]) + ", " + std::to_string(s[1]) + ", " + std::to_string(s[2]),
                 with_values(s[0], s[1], s[2])});
  }
  for (const double factor : {1e-6, 1e-8, 1e-20, 1e-22, 1e19, 1e20, 5e37, 1e-38, 1e-40, 1e-44}) {
    f.push_back({"Gaussian times " + std::to_string(std::log10(factor)) + " decades", gaussian_times(factor)});
  }
  return f;
}

template <class T>
class SvdOf : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(SvdOf, Reals);

void expect_accepted(const Errors& e) {
  EXPECT_EQ(e.not_finite, 0);
  EXPECT_LE(e.residual, 24);
  EXPECT_LE(e.orthogonality, 32);
  EXPECT_LE(e.values, 16);
  EXPECT_EQ(e.unordered, 0);
  EXPECT_EQ(e.wrong_sign, 0);
}

TYPED_TEST(SvdOf, reproduces_gaussian_matrices_to_a_few_eps) {
  Random random(1);
  const Errors e = errors_of<TypeParam>([](Random& r) { return r.gaussian(); }, 100000, random);
  expect_accepted(e);
  std::cout << "max residual " << e.residual << " eps, orthogonality " << e.orthogonality << " eps, values " << e.values
            << " eps\n";
  EXPECT_LE(e.residual, 12);
}

TYPED_TEST(SvdOf, accepts_every_hard_family) {
  Random random(2);
  for (const Family& family : hard_families()) {
    SCOPED_TRACE(family.name);
    expect_accepted(errors_of<TypeParam>(family.make, 3000, random));
  }
}

TYPED_TEST(SvdOf, scales_by_powers_of_two_bit_for_bit) {
  Random random(3);
  for (int k = 0; k < 1000; ++k) {
    const Matrix3<TypeParam> a = random.gaussian().template cast<TypeParam>();
    const auto factor = TypeParam(std::ldexp(1., random.integer(-80, 80)));
    const Vector3<TypeParam> s = svd(a).s, scaled = svd(Matrix3<TypeParam>(a * factor)).s;
    for (int i = 0; i < 3; ++i) ASSERT_EQ(s[i] * factor, scaled[i]);
  }
}

TYPED_TEST(SvdOf, turns_nan_and_infinity_into_nan) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (int k = 0; k < 9; ++k) {
      Matrix3<TypeParam> a = Matrix3<TypeParam>::Identity();
      a(k % 3, k / 3) = TypeParam(bad);
      EXPECT_TRUE(svd(a).s.hasNaN()) << "element " << k;
    }
  }
}

TYPED_TEST(SvdOf, gives_the_same_singular_values_for_the_transpose_and_rotated_matrices) {
  Random random(4);
  const double limit = 16 * std::numeric_limits<TypeParam>::epsilon();
  for (int k = 0; k < 2000; ++k) {
    const Eigen::Matrix3d a = random.gaussian();
    const auto values = [](const Eigen::Matrix3d& m) { return svd(Matrix3<TypeParam>(m.cast<TypeParam>())).s; };
    const Vector3<TypeParam> s = values(a);
    for (const Eigen::Matrix3d& b : {Eigen::Matrix3d(a.transpose()), Eigen::Matrix3d(random.rotation() * a),
                                     Eigen::Matrix3d(a * random.rotation())}) {
      ASSERT_LE((values(b) - s).cwiseAbs().maxCoeff(), limit * s[0]);
    }
  }
}

}  // namespace
}  // namespace physgen::fem
