// The material models against their energies, written out naively and differentiated in quadruple precision.
#include <fem/fixed_corotated.h>
#include <fem/neo_hookean.h>
#include <gtest/gtest.h>
#include <physgen/error.h>
#include <physgen/simd.h>

#include <algorithm>
#include <vector>

#include "reference.h"

namespace physgen::fem {
namespace {

using reference::Jet, reference::Quad, reference::Random;

Jet energy_of(const NeoHookean<double>& m, const std::array<Jet, 3>& s) {
  const Jet J = s[0] * s[1] * s[2];
  const Jet isochoric = Jet(m.mu / 2) * (s[0] * s[0] + s[1] * s[1] + s[2] * s[2] - Jet(3.));
  const Quad J0 = m.smallest_volume_ratio;
  if (J.value >= J0) {
    const Jet l = log(J);
    return isochoric - Jet(m.mu) * l + Jet(m.lambda / 2) * l * l;
  }
  const Quad l = reference::log(J0);
  const Quad phi = -m.mu * l + m.lambda * l * l / 2, slope = (m.lambda * l - m.mu) / J0,
             curvature = (m.mu + m.lambda - m.lambda * l) / (J0 * J0);
  const Jet d = J - Jet(J0);
  return isochoric + Jet(phi) + Jet(slope) * d + Jet(curvature / 2) * d * d;
}

Jet energy_of(const FixedCorotated<double>& m, const std::array<Jet, 3>& s) {
  Jet sum(0.);
  for (const Jet& x : s) sum = sum + (x - Jet(1.)) * (x - Jet(1.));
  const Jet change = s[0] * s[1] * s[2] - Jet(1.);
  return Jet(m.mu) * sum + Jet(m.lambda / 2) * change * change;
}

template <class Model>
Jet exact(const Model& m, const Vector3<double>& s) {
  return energy_of(m, {Jet::variable(s[0], 0), Jet::variable(s[1], 1), Jet::variable(s[2], 2)});
}

template <class S>
std::array<S, 12> entries(const PrincipalDerivative<S>& d) {
  return {d.h11, d.h21, d.h31, d.h22, d.h32, d.h33, d.d21, d.d31, d.d32, d.s21, d.s31, d.s32};
}

std::array<Quad, 12> exact_entries(const Jet& psi, const Vector3<double>& s) {
  const auto& H = psi.hessian;
  const auto& g = psi.gradient;
  const auto D = [&](std::size_t a, std::size_t b) {
    const Quad gap = Quad(s[int(a)]) - Quad(s[int(b)]);
    return gap == 0 ? H[a][a] - H[a][b] : (g[a] - g[b]) / gap;
  };
  const auto S = [&](std::size_t a, std::size_t b) { return (g[a] + g[b]) / (Quad(s[int(a)]) + Quad(s[int(b)])); };
  return {H[0][0], H[1][0], H[2][0], H[1][1], H[2][1], H[2][2], D(1, 0), D(2, 0), D(2, 1), S(1, 0), S(2, 0), S(2, 1)};
}

// How far the entries move, relative to the change, when one stretch changes a little: their condition.
template <class Model>
double sensitivity(const Model& m, const Vector3<double>& s, const std::array<Quad, 12>& expected) {
  double sum = 0;
  for (int a = 0; a < 3; ++a) {
    Vector3<double> moved = s;
    moved[a] *= 1 + 0x1p-24;
    const auto entries = exact_entries(exact(m, moved), moved);
    double most = 0;
    for (std::size_t k = 0; k < 12; ++k) most = std::max(most, std::abs(double(entries[k] - expected[k])));
    sum += most * 0x1p24;
  }
  return sum;
}

// Worst errors in eps: of psi relative to |psi| + mu |s - 1|^2 (with nu < 0, psi alone may vanish), of g relative to
// |H| |s| (a change of s by an eps moves it so far), of the 12 entries relative to the largest of them or, where they
// are ill-conditioned (J near e cancels all of lambda), to what an eps in s changes.
struct Errors {
  double energy = 0, stress = 0, derivative = 0;
};

template <class Model>
void measure(Errors& worst, const Model& m, const Vector3<double>& s) {
  const double eps = std::numeric_limits<double>::epsilon();
  const Jet psi = exact(m, s);
  const auto expected = exact_entries(psi, s);
  const auto got = entries(m.derivative(s));
  double scale = 0, error = 0;
  for (std::size_t k = 0; k < 12; ++k) {
    scale = std::max(scale, std::abs(double(expected[k])));
    error = std::max(error, std::abs(double(Quad(got[k]) - expected[k])));
  }
  if (error > 8 * eps * scale) error *= scale / std::max(scale, sensitivity(m, s, expected));
  worst.derivative = std::max(worst.derivative, error / scale / eps);
  const Vector3<double> g = m.stress(s);
  for (int a = 0; a < 3; ++a) {
    const double e = std::abs(double(Quad(g[a]) - psi.gradient[std::size_t(a)]));
    worst.stress = std::max(worst.stress, e / (scale * s.norm()) / eps);
  }
  const double e = std::abs(double(Quad(m.energy(s)) - psi.value));
  worst.energy = std::max(worst.energy,
                          e / (std::abs(double(psi.value)) + m.mu * (s - Vector3<double>::Ones()).squaredNorm()) / eps);
}

Vector3<double> sorted(double a, double b, double c) {
  std::array<double, 3> s{a, b, c};
  std::sort(s.begin(), s.end(), [](double x, double y) { return std::abs(x) > std::abs(y); });
  return {std::abs(s[0]), std::abs(s[1]), s[2]};
}

// Stretches in [0.05, 4]; two of five inverted, one of five compressed to almost nothing.
Vector3<double> random_stretch(Random& r) {
  const double flip = r.uniform(0, 1) < 0.4 ? -1 : 1;
  const double low = r.uniform(0, 1) < 0.2 ? 0.05 : 0.5;
  const Vector3<double> s = sorted(r.uniform(0.05, 4), r.uniform(0.05, 4), r.uniform(low, 4) * (low < 0.1 ? 0.05 : 1));
  return {s[0], s[1], flip * s[2]};
}

template <class Model>
class MaterialOf : public testing::Test {
 protected:
  // Tissue: nearly incompressible or not.
  std::vector<Model> models{Model::from(1e4, 0.45), Model::from(1e4, 0.49), Model::from(3e3, 0.3),
                            Model::from(1, -0.2)};
};
using Models = testing::Types<NeoHookean<double>, FixedCorotated<double>>;
TYPED_TEST_SUITE(MaterialOf, Models);

TYPED_TEST(MaterialOf, agrees_with_its_energy_differentiated_in_quadruple_precision) {
  Random random(1);
  for (const auto& m : this->models) {
    Errors worst;
    for (int k = 0; k < 25000; ++k) {
      const Vector3<double> s = random_stretch(random);
      if (s[1] + s[2] > 1e-3) measure(worst, m, s);
    }
    std::cout << m.name << ": psi " << worst.energy << " eps, g " << worst.stress << " eps, H D S " << worst.derivative
              << " eps\n";
    EXPECT_LE(worst.stress, 8);
    EXPECT_LE(worst.derivative, 8);
    EXPECT_LE(worst.energy, 8);
  }
}

TYPED_TEST(MaterialOf, has_no_noise_floor_near_rest) {
  Random random(2);
  const double eps = std::numeric_limits<double>::epsilon();
  for (const auto& m : this->models) {
    for (const double strain : {1e-1, 1e-4, 1e-8}) {
      double stress = 0, energy = 0;
      for (int k = 0; k < 2000; ++k) {
        const Vector3<double> s =
            sorted(1 + strain * random.normal(), 1 + strain * random.normal(), 1 + strain * random.normal());
        const Vector3<double> e = s - Vector3<double>::Ones();
        const Jet psi = exact(m, s);
        for (int a = 0; a < 3; ++a) {
          const double error = std::abs(double(Quad(m.stress(s)[a]) - psi.gradient[std::size_t(a)]));
          stress = std::max(stress, error / ((m.mu + std::abs(m.lambda)) * e.norm()) / eps);
        }
        energy = std::max(energy, std::abs(double(Quad(m.energy(s)) - psi.value)) /
                                      ((m.mu + std::abs(m.lambda)) * e.squaredNorm()) / eps);
      }
      EXPECT_LE(stress, 8) << m.name << " at strain " << strain;
      EXPECT_LE(energy, 16) << m.name << " at strain " << strain;
    }
  }
}

TYPED_TEST(MaterialOf, has_no_stress_and_the_lame_tangent_at_rest) {
  for (const auto& m : this->models) {
    const Vector3<double> rest = Vector3<double>::Ones();
    EXPECT_EQ(m.energy(rest), 0);
    for (int a = 0; a < 3; ++a) EXPECT_EQ(m.stress(rest)[a], 0);
    const auto d = m.derivative(rest);
    const double tolerance = 16e-16 * (2 * m.mu + std::abs(m.lambda));
    for (const double h : {d.h11, d.h22, d.h33}) EXPECT_NEAR(h, 2 * m.mu + m.lambda, tolerance);
    for (const double h : {d.h21, d.h31, d.h32}) EXPECT_NEAR(h, m.lambda, tolerance);
    for (const double D : {d.d21, d.d31, d.d32}) EXPECT_NEAR(D, 2 * m.mu, tolerance);
    for (const double S : {d.s21, d.s31, d.s32}) EXPECT_NEAR(S, 0, tolerance);
  }
}

TYPED_TEST(MaterialOf, is_continuous_where_two_stretches_meet) {
  Random random(3);
  for (const auto& m : this->models) {
    Errors worst;
    for (int k = 0; k < 500; ++k) {
      const double a = random.uniform(0.8, 3), c = random.uniform(0.1, 0.7);
      for (const double b : {a, std::nextafter(a, 0.), a - 1e-12, a - 1e-6}) {
        measure(worst, m, {a, b, c});
        measure(worst, m, {3.5, a, b});
      }
    }
    EXPECT_LE(worst.derivative, 8) << m.name;
  }
}

TYPED_TEST(MaterialOf, treats_the_principal_axes_alike) {
  Random random(4);
  for (const auto& m : this->models) {
    for (int k = 0; k < 1000; ++k) {
      const Vector3<double> s(random.uniform(0.5, 2), random.uniform(0.5, 2), random.uniform(0.5, 2));
      const auto d = m.derivative(s), e = m.derivative(Vector3<double>(s[1], s[2], s[0]));
      const auto g = m.stress(s), h = m.stress(Vector3<double>(s[1], s[2], s[0]));
      const double t = 1e-14 * (std::abs(d.h11) + std::abs(d.h33) + m.mu + std::abs(m.lambda) * 4);
      EXPECT_NEAR(g[0], h[2], t);
      EXPECT_NEAR(g[1], h[0], t);
      EXPECT_NEAR(d.h11, e.h33, t);
      EXPECT_NEAR(d.h21, e.h31, t);
      EXPECT_NEAR(d.d21, e.d31, t);
      EXPECT_NEAR(d.s32, e.s21, t);
    }
  }
}

TYPED_TEST(MaterialOf, is_finite_for_flattened_collapsed_and_inverted_elements) {
  for (const auto& m : this->models) {
    for (const Vector3<double>& s :
         {Vector3<double>(1, 1, 0), Vector3<double>(1, 0, 0), Vector3<double>(0, 0, 0), Vector3<double>(1, 1, -1),
          Vector3<double>(2, 0.5, -0.5), Vector3<double>(1e3, 1, -1)}) {
      EXPECT_TRUE(std::isfinite(m.energy(s)));
      EXPECT_TRUE(m.stress(s).allFinite());
      for (const double x : entries(m.derivative(s))) EXPECT_TRUE(std::isfinite(x));
    }
  }
}

TYPED_TEST(MaterialOf, gives_packs_what_it_gives_numbers) {
  using B = Batch<double>;
  Random random(5);
  const auto& m = this->models[0];
  for (int k = 0; k < 1000; ++k) {
    const Vector3<double> s = random_stretch(random);
    const Vector3<B> packed{B(s[0]), B(s[1]), B(s[2])};
    const auto one = entries(m.derivative(s));
    const auto many = entries(m.derivative(packed));
    double scale = 0;
    for (const double x : one) scale = std::max(scale, std::abs(x));
    for (std::size_t i = 0; i < 12; ++i) EXPECT_NEAR(one[i], many[i].get(0), 4e-14 * scale);
    EXPECT_NEAR(m.energy(s), m.energy(packed).get(0), 1e-13 * std::abs(m.energy(s)));
  }
}

TEST(NeoHookean, has_a_continuous_stress_and_derivative_where_the_extrapolation_begins) {
  const auto m = NeoHookean<double>::from(1e4, 0.45);
  const auto at = [](double J) { return Vector3<double>(1.2, 0.8, J / (1.2 * 0.8)); };
  const double J0 = m.smallest_volume_ratio;
  const auto above = at(J0 * (1 + 1e-12)), below = at(J0 * (1 - 1e-12));
  const auto d = entries(m.derivative(above)), e = entries(m.derivative(below));
  EXPECT_NEAR(m.energy(above), m.energy(below), 1e-9 * m.energy(above));
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(m.stress(above)[a], m.stress(below)[a], 1e-9 * m.stress(above).norm());
  for (std::size_t k = 0; k < 12; ++k) EXPECT_NEAR(d[k], e[k], 1e-9 * std::abs(d[5]));
}

TEST(NeoHookean, follows_the_published_uniaxial_stretch) {
  // Side stretch and stress at l1 = 0.8175, nu = 0.45, E = 1, from 40-digit arithmetic.
  const auto m = NeoHookean<double>::from(1, 0.45);
  const Vector3<double> g = m.stress(Vector3<double>(1.0939769, 1.0939769, 0.8175));
  EXPECT_NEAR(g[0], 0, 1e-5);
  EXPECT_NEAR(g[2], -0.2229165, 1e-5);
}
TEST(FixedCorotated, follows_the_published_uniaxial_stretch) {
  const auto m = FixedCorotated<double>::from(1, 0.49);
  const Vector3<double> g = m.stress(Vector3<double>(1.103412, 1.103412, 0.8175));
  EXPECT_NEAR(g[0], 0, 1e-4);
  EXPECT_NEAR(g[2], -0.2161604, 1e-4);
}
TEST(FixedCorotated, caps_its_derivative_at_the_pole_as_documented) {
  const auto m = FixedCorotated<double>::from(1e4, 0.45);
  const auto d = m.derivative(Vector3<double>(1, 0.5, -0.5));
  EXPECT_LE(std::abs(d.s32), 4 * m.mu / m.smallest_stretch_sum + 10 * m.lambda);
}

template <class Model>
void expect_refusal(double E, double nu, const std::string& value) {
  try {
    Model::from(E, nu);
    FAIL() << "accepted E = " << E << ", nu = " << nu;
  } catch (const Error& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find(Model::name), std::string::npos) << what;
    EXPECT_NE(what.find(value), std::string::npos) << what;
    EXPECT_NE(what.find("allowed is"), std::string::npos) << what;
  }
}

TYPED_TEST(MaterialOf, refuses_constants_out_of_range_with_value_range_and_name) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  expect_refusal<TypeParam>(0, 0.3, "E = 0");
  expect_refusal<TypeParam>(-5, 0.3, "E = -5");
  expect_refusal<TypeParam>(inf, 0.3, "E = inf");
  expect_refusal<TypeParam>(nan, 0.3, "E = nan");
  expect_refusal<TypeParam>(1, 0.5, "nu = 0.5");
  expect_refusal<TypeParam>(1, -1, "nu = -1");
  expect_refusal<TypeParam>(1, nan, "nu = nan");
}

}  // namespace
}  // namespace physgen::fem
