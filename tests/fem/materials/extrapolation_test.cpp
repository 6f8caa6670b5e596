// Models with a pole: continued below a small volume ratio, or capped beside s_a + s_b = 0, as their headers say.
#include "material_checks.h"

namespace physgen::fem {
namespace {

// With the default and with the ends of what is allowed.
template <class Model>
std::vector<std::pair<Elasticity, Model>> models_with_thresholds() {
  std::vector<std::pair<Elasticity, Model>> result;
  for (const Elasticity& constants : tested_constants) {
    for (const double J0 : {Model().smallest_volume_ratio, 0.01, 0.5}) {
      auto m = model_of<Model>(constants);
      m.smallest_volume_ratio = J0;
      result.emplace_back(constants, m);
    }
  }
  return result;
}

template <class Model>
class Extrapolation : public testing::Test {};
using ModelsWithPoleAtZeroVolume = testing::Types<NeoHookean<double>, MooneyRivlin<double>>;
TYPED_TEST_SUITE(Extrapolation, ModelsWithPoleAtZeroVolume);

TYPED_TEST(Extrapolation, begins_with_continuous_energy_stress_and_derivative) {
  for (const auto& [constants, m] : models_with_thresholds<TypeParam>()) {
    const auto at = [](double J) { return Vector3<double>(1.2, 0.8, J / (1.2 * 0.8)); };
    const double J0 = m.smallest_volume_ratio;
    const auto above = at(J0 * (1 + 1e-12)), below = at(J0 * (1 - 1e-12));
    const auto d = entries(m.derivative(above)), e = entries(m.derivative(below));
    EXPECT_NEAR(m.energy(above), m.energy(below), 1e-9 * m.energy(above));
    for (int a = 0; a < 3; ++a) EXPECT_NEAR(m.stress(above)[a], m.stress(below)[a], 1e-9 * m.stress(above).norm());
    for (std::size_t k = 0; k < 12; ++k) EXPECT_NEAR(d[k], e[k], 1e-9 * std::abs(d[5])) << reference::entry_names[k];
  }
}

TYPED_TEST(Extrapolation, is_as_accurate_as_the_rest_next_to_and_below_the_threshold) {
  Random random(8);
  for (const auto& [constants, m] : models_with_thresholds<TypeParam>()) {
    MaterialErrors<TypeParam> errors(m, constants);
    for (int k = 0; k < 150; ++k) {
      const double a = random.uniform(0.5, 3), b = random.uniform(0.5, 3), J0 = m.smallest_volume_ratio;
      for (const double J : {J0, std::nextafter(J0, 0.), J0 * (1 - 1e-8), 0.1 * J0, 1e-10, -1e-10, -J0}) {
        errors.add(sorted(a, b, J / (a * b)));
      }
    }
    EXPECT_LE(errors.energy.max(), 8) << m.name << " J0 " << m.smallest_volume_ratio << " nu " << constants.nu;
    EXPECT_LE(errors.stress.max(), 8) << m.name << " J0 " << m.smallest_volume_ratio << " nu " << constants.nu;
    EXPECT_LE(errors.judged().max(), 8) << m.name << " J0 " << m.smallest_volume_ratio << " nu " << constants.nu;
  }
}

TYPED_TEST(Extrapolation, pushes_flattened_and_inverted_elements_back) {
  const auto m = model_of<TypeParam>(tested_constants[0]);
  for (const double s : {0.1, 0., -0.5, -1.}) {
    EXPECT_LT(m.stress(Vector3<double>(1, 1, s))[2], 0) << s;
    EXPECT_GT(m.energy(Vector3<double>(1, 1, s - 0.01)), m.energy(Vector3<double>(1, 1, s))) << s;
  }
}

template <class Model>
class PoleCap : public testing::Test {};
using ModelsWithPoleAtOppositeStretches = testing::Types<Corotated<double>, FixedCorotated<double>>;
TYPED_TEST_SUITE(PoleCap, ModelsWithPoleAtOppositeStretches);

TYPED_TEST(PoleCap, bounds_the_derivative_and_changes_nothing_elsewhere) {
  auto m = model_of<TypeParam>(tested_constants[0]);
  for (const double cap : {m.smallest_stretch_sum, 1e-6, 1.}) {  // the default and the ends of what is allowed
    m.smallest_stretch_sum = cap;
    const double bound = 2 * m.mu + 2 * (2 * m.mu + 3 * m.lambda) / cap;  // trace and (J - 1) s_c are above -3
    for (const double gap : {0., 1e-300, 1e-9, cap / 2, cap, -cap / 2}) {
      const auto d = m.derivative(Vector3<double>(1, 0.5, -0.5 + gap));
      EXPECT_LE(std::abs(d.s32), bound) << gap;
      EXPECT_LE(std::abs(d.s21), 10 * (m.mu + m.lambda)) << gap;
    }
    const Vector3<double> beside(1, 0.5, -0.5 + 1.001 * cap);
    const auto errors = reference::principal_errors(m, m.mu, cap < 1 ? beside : Vector3<double>(1.2, 0.6, 0.55));
    EXPECT_LE(errors.entries, 8) << cap;
  }
}

}  // namespace
}  // namespace physgen::fem
