// Accuracy of every material model: energy, stress and stress derivative against the energy written out naively and
// differentiated in quadruple precision.
#include "material_checks.h"

namespace physgen::fem {
namespace {

template <class Model>
class MaterialAccuracy : public testing::Test {};
TYPED_TEST_SUITE(MaterialAccuracy, MaterialTypes<double>);

template <class Model>
class MaterialAccuracyInFloat : public testing::Test {};
TYPED_TEST_SUITE(MaterialAccuracyInFloat, MaterialTypes<float>);

template <class Model>
void check_random_stretches(int count) {
  Random random(1);
  for (const Elasticity& constants : tested_constants) {
    const auto model = model_of<Model>(constants);
    if (const auto s = replayed_stretch()) {
      print_beside_oracle(model, constants, Vector3<typename Model::Scalar>(s->cast<typename Model::Scalar>()));
      continue;
    }
    MaterialErrors<Model> errors(model, constants);
    for (int k = 0; k < count; ++k) errors.add(random_stretch(random));
    for (int k = 0; k < count / 4; ++k) errors.add(compressed_stretch(random));
    errors.print();
    EXPECT_LE(errors.energy.max(), 8);
    EXPECT_LE(errors.stress.max(), 8);
    EXPECT_LE(errors.judged().max(), 8);
  }
}

// A model whose first stress or first entry is not a number.
struct BrokenStress : NeoHookean<double> {
  template <class S>
  Vector3<S> stress(const Vector3<S>& s) const {
    Vector3<S> g = NeoHookean<double>::stress(s);
    g[0] = std::numeric_limits<double>::quiet_NaN();
    return g;
  }
};
struct BrokenEntry : NeoHookean<double> {
  template <class S>
  PrincipalDerivative<S> derivative(const Vector3<S>& s) const {
    PrincipalDerivative<S> d = NeoHookean<double>::derivative(s);
    d.h11 = std::numeric_limits<double>::quiet_NaN();
    return d;
  }
};

TEST(PrincipalErrors, see_a_nan_that_finite_errors_follow) {
  const auto m = NeoHookean<double>::from(1e4, 0.45);
  const Vector3<double> s(1.5, 1, 0.5);
  const auto stress = reference::principal_errors(BrokenStress{m}, m.mu, s);
  EXPECT_TRUE(std::isnan(stress.stress));
  EXPECT_LE(stress.entries, 8);
  const auto entry = reference::principal_errors(BrokenEntry{m}, m.mu, s);
  EXPECT_TRUE(std::isnan(entry.entries));
  EXPECT_TRUE(std::isnan(entry.conditioned));
  EXPECT_LE(entry.stress, 8);
  ErrorDistribution errors;
  errors.add(entry.entries);
  errors.add(1);
  EXPECT_FALSE(errors.max() <= 8);
}

TYPED_TEST(MaterialAccuracy, is_8_eps_of_the_energy_differentiated_in_quadruple_precision) {
  check_random_stretches<TypeParam>(25000);  // for each of 4 pairs of constants
}
TYPED_TEST(MaterialAccuracyInFloat, is_8_eps_of_the_energy_differentiated_in_quadruple_precision) {
  check_random_stretches<TypeParam>(12500);
}

TYPED_TEST(MaterialAccuracy, holds_across_any_gap_between_two_stretches) {
  Random random(3);
  for (const Elasticity& constants : tested_constants) {
    MaterialErrors<TypeParam> errors(model_of<TypeParam>(constants), constants);
    for (int k = 0; k < 300; ++k) {
      const double a = random.uniform(0.8, 3), c = random.uniform(0.1, 0.7);
      for (const double b : {a, std::nextafter(a, 0.), a - 1e-12, a - 1e-6}) {
        errors.add({a, b, c});
        errors.add({3.5, a, b});
        errors.add({a, c, b});
        errors.add({a, b, -c});
        errors.add({3.5, a, -b + 0.01});
      }
    }
    EXPECT_LE(errors.judged().max(), 8) << TypeParam::name;
    EXPECT_LE(errors.stress.max(), 8) << TypeParam::name;
  }
}

TYPED_TEST(MaterialAccuracy, derivative_does_not_jump_where_two_stretches_meet) {
  Random random(6);
  for (const Elasticity& constants : tested_constants) {
    const auto m = model_of<TypeParam>(constants);
    for (int k = 0; k < 300; ++k) {
      const double a = random.uniform(0.8, 3), c = random.uniform(0.3, 0.7);
      const auto met = entries(m.derivative(Vector3<double>(a, a, c)));
      double largest = 0;
      for (const double x : met) largest = std::max(largest, std::abs(x));
      for (const double gap : {a - std::nextafter(a, 0.), 1e-12, 1e-6}) {
        const auto apart = entries(m.derivative(Vector3<double>(a, a - gap, c)));
        for (std::size_t i = 0; i < 12; ++i) EXPECT_NEAR(met[i], apart[i], (20 * gap / c + 4e-15) * largest) << m.name;
      }
    }
  }
}

TYPED_TEST(MaterialAccuracy, has_no_noise_floor_near_rest) {
  Random random(2);
  const double eps = std::numeric_limits<double>::epsilon();
  for (const Elasticity& constants : tested_constants) {
    const auto m = model_of<TypeParam>(constants);
    const double modulus = constants.lame().mu + std::abs(constants.lame().lambda);
    for (const double strain : {1e-1, 1e-4, 1e-8}) {  // below, energies of 1e-20 leave the oracle no digits
      ErrorDistribution stress, energy;
      for (int k = 0; k < 1000; ++k) {
        const double a = random.normal(), b = random.normal(), c = random.normal();
        const Vector3<double> s = sorted(1 + strain * a, 1 + strain * b, 1 + strain * c);
        const Vector3<double> e = s - Vector3<double>::Ones();
        const Jet psi = reference::exact_energy(m, s);
        for (int i = 0; i < 3; ++i) {
          const double error = std::abs(double(Quad(m.stress(s)[i]) - psi.gradient[std::size_t(i)]));
          stress.add(error / (modulus * e.norm()) / eps);
        }
        const double error = std::abs(double(Quad(m.energy(s)) - psi.value));
        energy.add(error / (modulus * e.squaredNorm()) / eps);
      }
      EXPECT_LE(stress.max(), 8) << m.name << " at strain " << strain;
      EXPECT_LE(energy.max(), 8) << m.name << " at strain " << strain;
    }
  }
}

}  // namespace
}  // namespace physgen::fem
