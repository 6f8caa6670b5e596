// Properties of every material model, whatever its energy: rest state, symmetries, isotropy, finite values for
// flattened and inverted elements, packs like numbers, NaN in and NaN out.
#include <fem/numerics/svd.h>

#include "material_checks.h"

namespace physgen::fem {
namespace {

template <class Model>
class MaterialProperties : public testing::Test {
 protected:
  static std::vector<Model> models() {
    std::vector<Model> result;
    for (const Elasticity& e : tested_constants) result.push_back(model_of<Model>(e));
    return result;
  }
  static double largest(const Entries<double>& entries) {
    double most = 0;
    for (const double x : entries) most = std::max(most, std::abs(x));
    return most;
  }
  static double modulus(const Model& m) { return largest(entries(m.derivative(Vector3<double>(1, 1, 1)))); }
};
TYPED_TEST_SUITE(MaterialProperties, MaterialTypes<double>);

template <class Model>
class MaterialPropertiesInFloat : public testing::Test {};
TYPED_TEST_SUITE(MaterialPropertiesInFloat, MaterialTypes<float>);

template <class Model>
void check_rest() {
  using Real = typename Model::Scalar;
  for (const Elasticity& constants : tested_constants) {
    const auto m = model_of<Model>(constants);
    const auto [mu, lambda] = constants.lame();
    const Vector3<Real> rest = Vector3<Real>::Ones();
    EXPECT_EQ(m.energy(rest), 0);
    for (int a = 0; a < 3; ++a) EXPECT_EQ(m.stress(rest)[a], 0);
    const auto d = m.derivative(rest);
    const double tolerance = 8 * double(std::numeric_limits<Real>::epsilon()) * (2 * mu + std::abs(lambda));
    for (const Real h : {d.h11, d.h22, d.h33}) EXPECT_NEAR(double(h), 2 * mu + lambda, tolerance) << m.name;
    for (const Real h : {d.h21, d.h31, d.h32}) EXPECT_NEAR(double(h), lambda, tolerance) << m.name;
    for (const Real D : {d.d21, d.d31, d.d32}) EXPECT_NEAR(double(D), 2 * mu, tolerance) << m.name;
    for (const Real S : {d.s21, d.s31, d.s32}) EXPECT_NEAR(double(S), 0, tolerance) << m.name;
  }
}
TYPED_TEST(MaterialProperties, no_stress_and_the_lame_tangent_at_rest) { check_rest<TypeParam>(); }
TYPED_TEST(MaterialPropertiesInFloat, no_stress_and_the_lame_tangent_at_rest) { check_rest<TypeParam>(); }

// P(F) = U diag(g) V^T
template <class Model, class Real>
Matrix3<Real> stress_of(const Model& m, const Svd<Real>& f) {
  return f.U * m.stress(f.s).asDiagonal() * f.V.transpose();
}

// A rotation, each entry rounded once.
template <class Real>
Matrix3<Real> rounded_rotation(Random& random) {
  const double w = random.normal(), x = random.normal(), y = random.normal(), z = random.normal();
  return Eigen::Quaternion<long double>(w, x, y, z).normalized().toRotationMatrix().template cast<Real>();
}

// Such a rotation strains by an eps or so, and lambda times as much is pressure: the limit is 32 eps mu where
// lambda <= mu, and in lambda beyond, where in mu it would speak of lambda / mu and not of the arithmetic.
template <class Model>
void check_rotations() {
  using Real = typename Model::Scalar;
  Random random(9);
  const double eps = std::numeric_limits<Real>::epsilon();
  std::vector<Elasticity> all(tested_constants.begin(), tested_constants.end());
  all.push_back({1, 0.2});
  for (const Elasticity& constants : all) {
    const auto m = model_of<Model>(constants);
    const auto [mu, lambda] = constants.lame();
    ErrorDistribution stress;
    for (int k = 0; k < 2000; ++k) {
      const Svd<Real> f = svd(rounded_rotation<Real>(random));
      for (int a = 0; a < 3; ++a) EXPECT_NEAR(double(f.s[a]), 1, 8 * eps);
      stress.add(double(stress_of(m, f).norm()) / eps / std::max(mu, lambda));
    }
    std::printf("%s, %s, nu = %g: a rotation gives up to %.1f eps max(mu, lambda)\n", m.name,
                sizeof(Real) == 4 ? "float" : "double", constants.nu, stress.max());
    EXPECT_LE(stress.max(), 32) << m.name << " nu " << constants.nu;
  }
}
TYPED_TEST(MaterialProperties, a_rotation_gives_no_stress) { check_rotations<TypeParam>(); }
TYPED_TEST(MaterialPropertiesInFloat, a_rotation_gives_no_stress) { check_rotations<TypeParam>(); }

TYPED_TEST(MaterialProperties, the_principal_axes_are_alike) {
  Random random(4);
  for (const auto& m : this->models()) {
    for (int k = 0; k < 1000; ++k) {
      const Vector3<double> s = random_stretch(random);
      if (is_capped(m, s)) continue;
      const std::array<std::array<int, 3>, 5> permutations{{{1, 0, 2}, {2, 1, 0}, {0, 2, 1}, {1, 2, 0}, {2, 0, 1}}};
      const auto g = m.stress(s);
      const auto d = m.derivative(s);
      const double scale = this->largest(entries(d));
      for (const auto& p : permutations) {
        const Vector3<double> turned(s[p[0]], s[p[1]], s[p[2]]);
        const auto h = m.stress(turned);
        const auto e = m.derivative(turned);
        const auto at = [&p](double a11, double a21, double a31, double a22, double a32, double a33, int r, int c) {
          Eigen::Matrix3d A;
          A << a11, a21, a31, a21, a22, a32, a31, a32, a33;
          return A(p[std::size_t(r)], p[std::size_t(c)]);
        };
        const auto H = [&](int r, int c) { return at(d.h11, d.h21, d.h31, d.h22, d.h32, d.h33, r, c); };
        const auto D = [&](int r, int c) { return at(0, d.d21, d.d31, 0, d.d32, 0, r, c); };
        const auto S = [&](int r, int c) { return at(0, d.s21, d.s31, 0, d.s32, 0, r, c); };
        const double t = 4e-15 * scale;  // twice 8 eps
        for (int a = 0; a < 3; ++a) EXPECT_NEAR(h[a], g[p[std::size_t(a)]], t * s.norm());
        const Entries<double> expected{H(0, 0), H(1, 0), H(2, 0), H(1, 1), H(2, 1), H(2, 2),
                                       D(1, 0), D(2, 0), D(2, 1), S(1, 0), S(2, 0), S(2, 1)};
        const auto got = entries(e);
        for (std::size_t i = 0; i < 12; ++i) EXPECT_NEAR(got[i], expected[i], t) << m.name;
      }
    }
  }
}

TYPED_TEST(MaterialProperties, finite_for_flattened_collapsed_and_inverted_elements) {
  for (const auto& m : this->models()) {
    for (const Vector3<double>& s :
         {Vector3<double>(1, 1, 0), Vector3<double>(1, 0, 0), Vector3<double>(0, 0, 0), Vector3<double>(1, 1, -1),
          Vector3<double>(2, 0.5, -0.5), Vector3<double>(1e3, 1, -1), Vector3<double>(1e-200, 1e-250, -1e-300)}) {
      EXPECT_TRUE(std::isfinite(m.energy(s))) << m.name << " " << s.transpose();
      EXPECT_TRUE(m.stress(s).allFinite()) << m.name << " " << s.transpose();
      for (const double x : entries(m.derivative(s))) EXPECT_TRUE(std::isfinite(x)) << m.name << " " << s.transpose();
    }
  }
}

TYPED_TEST(MaterialProperties, nan_and_infinity_in_any_stretch_reach_energy_stress_and_the_entries) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const auto m = this->models()[0];
  for (const double bad : {nan, -nan, infinity, -infinity}) {
    for (int a = 0; a < 3; ++a) {
      Vector3<double> s(1.1, 1, 0.9);
      s[a] = bad;
      EXPECT_FALSE(std::isfinite(m.energy(s))) << m.name << " " << s.transpose();
      EXPECT_FALSE(std::isfinite(m.stress(s)[a])) << m.name << " " << s.transpose();
      int finite = 0;
      for (const double x : entries(m.derivative(s))) finite += std::isfinite(x) ? 1 : 0;
      if (std::isnan(bad)) {
        // St Venant-Kirchhoff's H21 = lambda s1 s2 does not depend on s3, and so for others.
        EXPECT_LE(finite, 3) << m.name << " " << s.transpose();
      } else {
        EXPECT_LT(finite, 12) << m.name << " " << s.transpose();
      }
    }
  }
}

TYPED_TEST(MaterialProperties, packs_give_what_numbers_give) {
  using B = Batch<double>;
  Random random(5);
  for (const auto& m : this->models()) {
    for (int k = 0; k < 1000; ++k) {
      const Vector3<double> s = random_stretch(random);
      const Vector3<B> packed{B(s[0]), B(s[1]), B(s[2])};
      const auto one = entries(m.derivative(s));
      const auto many = entries(m.derivative(packed));
      const auto g = m.stress(s);
      const auto h = m.stress(packed);
      // Mooney-Rivlin's estimates of a cube root differ, and with them, rarely, a last digit. All else is the same
      // operations.
      const double t = std::is_same_v<TypeParam, MooneyRivlin<double>> ? 1e-15 * this->largest(one) : 0;
      for (std::size_t i = 0; i < 12; ++i) EXPECT_NEAR(one[i], many[i].get(0), t);
      for (int a = 0; a < 3; ++a) EXPECT_NEAR(g[a], h[a].get(0), t * s.norm());
      const double energy = m.energy(s);
      EXPECT_NEAR(energy, m.energy(packed).get(0), t > 0 ? 1e-14 * (std::abs(energy) + this->modulus(m)) : 0);
    }
  }
}

// dP(dF) by the 12 entries.
Matrix3<double> differential(const PrincipalDerivative<double>& d, const Svd<double>& f, const Matrix3<double>& dF) {
  const Matrix3<double> x = f.U.transpose() * dF * f.V;
  Matrix3<double> y, H, D, S;
  H << d.h11, d.h21, d.h31, d.h21, d.h22, d.h32, d.h31, d.h32, d.h33;
  D << 0, d.d21, d.d31, d.d21, 0, d.d32, d.d31, d.d32, 0;
  S << 0, d.s21, d.s31, d.s21, 0, d.s32, d.s31, d.s32, 0;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) y(a, b) = (D(a, b) * (x(a, b) + x(b, a)) + S(a, b) * (x(a, b) - x(b, a))) / 2;
    y(a, a) = H.row(a).dot(x.diagonal());
  }
  return f.U * y * f.V.transpose();
}

TYPED_TEST(MaterialProperties, stress_turns_with_the_frames_and_its_differential_is_self_adjoint) {
  Random random(7);
  const double eps = std::numeric_limits<double>::epsilon();
  for (const auto& m : this->models()) {
    for (int k = 0; k < 500; ++k) {
      const Vector3<double> s = random_stretch(random);
      if (s[1] + s[2] < 0.01) continue;  // beside the pole of corotated models, U V^T turns with the last digit of F
      const Matrix3<double> Q = random.rotation(), R = random.rotation(), U = random.rotation(), V = random.rotation();
      const Matrix3<double> F = U * s.asDiagonal() * V.transpose(), turned = Q * F * R;
      const Svd<double> f = svd(F);
      const auto d = m.derivative(f.s);
      const double scale = this->largest(entries(d));
      const Matrix3<double> P = stress_of(m, f), turned_P = stress_of(m, svd(turned));
      EXPECT_LE((turned_P - Q * P * R).norm(), 256 * eps * scale * s.norm()) << m.name << " " << s.transpose();

      // Central differences of the stress, error about h^2 and eps / h: they are self-adjoint, as those of an energy's
      // stress are, and what the 12 entries give.
      const double h = 1e-6 * std::abs(s[2]);
      const auto difference = [&](const Matrix3<double>& dF) -> Matrix3<double> {
        return (stress_of(m, svd(Matrix3<double>(F + h * dF))) - stress_of(m, svd(Matrix3<double>(F - h * dF)))) /
               (2 * h);
      };
      const Matrix3<double> dF1 = random.gaussian(), dF2 = random.gaussian();
      const Matrix3<double> dP1 = difference(dF1), dP2 = difference(dF2);
      EXPECT_NEAR(dF1.cwiseProduct(dP2).sum(), dF2.cwiseProduct(dP1).sum(), 1e-5 * scale * dF1.norm() * dF2.norm())
          << m.name << " " << s.transpose();
      EXPECT_LE((dP1 - differential(d, f, dF1)).norm(), 1e-5 * scale * dF1.norm()) << m.name << " " << s.transpose();
    }
  }
}

}  // namespace
}  // namespace physgen::fem
