// The constants of the material models: the uniaxial stretches known to 40 digits follow from them, and those out of
// range are refused with the value, the range and the model's name.
#include <physgen/error.h>

#include <functional>

#include "material_checks.h"

namespace physgen::fem {
namespace {

// Side stretch y and stress P1 of a stretch l1 with free sides and E = 1, from 40-digit arithmetic: y to 6 decimals,
// P1 to 7.
struct Uniaxial {
  double side, stress;
};
struct UniaxialRow {
  double nu, l1;
  Uniaxial neo_hookean, st_venant_kirchhoff, corotated, fixed_corotated, stable_neo_hookean;
};
constexpr std::array<UniaxialRow, 4> uniaxial_table{{
    {0.45,
     0.95,
     {1.023295, -0.05249848},
     {1.021702, -0.0463125},
     {1.0225, -0.05},
     {1.023248, -0.05175234},
     {1.023275, -0.05248327}},
    {0.45,
     0.875,
     {1.061537, -0.1423589},
     {1.051413, -0.1025391},
     {1.05625, -0.125},
     {1.061189, -0.1373853},
     {1.061381, -0.1422288}},
    {0.45,
     0.8175,
     {1.093977, -0.2229165},
     {1.072036, -0.1355798},
     {1.082125, -0.1825},
     {1.093122, -0.2117364},
     {1.093588, -0.2225572}},
    {0.49,
     0.8175,
     {1.103547, -0.2255649},
     {1.078207, -0.1355798},
     {1.089425, -0.1825},
     {1.103412, -0.2161604},
     {1.103531, -0.2255501}},
}};

template <class Model>
void expect_uniaxial(const UniaxialRow& row, const Uniaxial& expected) {
  const auto m = Model::from(1, row.nu);
  // The sides' stress grows with their stretch: bisection.
  double low = 0.9, high = 1.3;
  for (int step = 0; step < 60; ++step) {
    const double y = (low + high) / 2;
    (m.stress(Vector3<double>(y, y, row.l1))[0] < 0 ? low : high) = y;
  }
  EXPECT_NEAR(low, expected.side, 6e-7) << m.name << " nu " << row.nu << " l1 " << row.l1;
  EXPECT_NEAR(m.stress(Vector3<double>(low, low, row.l1))[2], expected.stress, 6e-8)
      << m.name << " nu " << row.nu << " l1 " << row.l1;
}

TEST(MaterialConstants, give_the_uniaxial_stretches_of_40_digit_arithmetic) {
  for (const UniaxialRow& row : uniaxial_table) {
    expect_uniaxial<NeoHookean<double>>(row, row.neo_hookean);
    expect_uniaxial<StVenantKirchhoff<double>>(row, row.st_venant_kirchhoff);
    expect_uniaxial<Corotated<double>>(row, row.corotated);
    expect_uniaxial<FixedCorotated<double>>(row, row.fixed_corotated);
    expect_uniaxial<StableNeoHookean<double>>(row, row.stable_neo_hookean);
  }
}

void expect_refusal(const std::function<void()>& make, const std::string& name, const std::string& value) {
  try {
    make();
    FAIL() << "accepted " << value;
  } catch (const Error& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find(name), std::string::npos) << what;
    EXPECT_NE(what.find(value), std::string::npos) << what;
    EXPECT_NE(what.find("allowed is"), std::string::npos) << what;
  }
}

template <class Model>
class MaterialConstantsOf : public testing::Test {};
TYPED_TEST_SUITE(MaterialConstantsOf, MaterialTypes<double>);

TYPED_TEST(MaterialConstantsOf, are_refused_out_of_range_with_value_range_and_name) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const auto refused = [](double E, double nu, const std::string& value) {
    expect_refusal([&] { TypeParam::from(E, nu); }, TypeParam::name, value);
  };
  refused(0, 0.3, "E = 0");
  refused(-5, 0.3, "E = -5");
  refused(infinity, 0.3, "E = inf");
  refused(nan, 0.3, "E = nan");
  refused(1, 0.5, "nu = 0.5");
  refused(1, 0.75, "nu = 0.75");
  refused(1, -1, "nu = -1");
  refused(1, infinity, "nu = inf");
  refused(1, nan, "nu = nan");
}

template <class Model>
class MaterialConstantsInFloat : public testing::Test {};
TYPED_TEST_SUITE(MaterialConstantsInFloat, MaterialTypes<float>);

TYPED_TEST(MaterialConstantsInFloat, are_refused_where_a_float_cannot_hold_what_follows_from_them) {
  const auto refused = [](double E, double nu) {
    expect_refusal([&] { TypeParam::from(E, nu); }, TypeParam::name, " = ");
    expect_refusal([&] { TypeParam::from(E, nu); }, TypeParam::name, "e+37 [Pa]");  // the range, in numbers
  };
  refused(1e40, 0.3);
  refused(1e38, 0.4999999999);
  refused(1.5e38, 0.3);   // mu fits, 3 mu + lambda would not
  refused(1e37, 0.4999);  // so does not lambda
  refused(1e-50, 0.3);    // mu would be 0
  refused(1e-40, 0.3);    // mu would lose its digits
}

TYPED_TEST(MaterialConstantsInFloat, at_either_end_of_what_is_accepted_give_a_finite_tangent_at_rest) {
  for (const double nu : {-0.5, 0., 0.3, 0.45}) {
    for (const double E : {1e-36, 4e36}) {
      const auto m = TypeParam::from(E, nu);
      const auto d = m.derivative(Vector3<float>(1, 1, 1));
      for (const float x : entries(d)) EXPECT_TRUE(std::isfinite(x)) << m.name << " " << E << " " << nu;
      EXPECT_NEAR(double(d.d21) / (E / (1 + nu)), 1, 1e-5) << m.name << " " << E << " " << nu;
    }
  }
}

TYPED_TEST(MaterialConstantsOf, are_refused_where_a_double_cannot_hold_what_follows_from_them) {
  const auto refused = [](double E, double nu) {
    expect_refusal([&] { TypeParam::from(E, nu); }, TypeParam::name, "e+307 [Pa]");
  };
  refused(1e308, 0.3);
  refused(1e307, 0.4999999999);
  refused(1e-320, 0.3);
}

TEST(MooneyRivlin, takes_its_own_constants_and_refuses_them_out_of_range) {
  using Model = MooneyRivlin<double>;
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const auto m = Model::from(MooneyRivlinConstants{30e3, 10e3, 60e3});  // [Pa]
  const auto d = m.derivative(Vector3<double>(1, 1, 1));
  EXPECT_NEAR(d.d21, 2 * 80e3, 1e-9);  // 2 mu, mu = 2 (m10 + m01)
  EXPECT_NEAR(d.h21, 60e3 - 2. / 3 * 80e3, 1e-9);
  const auto refused = [](const MooneyRivlinConstants& constants, const std::string& value) {
    expect_refusal([&] { Model::from(constants); }, Model::name, value);
  };
  refused({-1, 10, 1}, "m10 = -1");
  refused({nan, 10, 1}, "m10 = nan");
  refused({1, -2, 1}, "m01 = -2");
  refused({1, infinity, 1}, "m01 = inf");
  refused({0, 0, 1}, "m10 + m01 = 0");
  refused({1, 1, 0}, "kappa = 0");
  refused({1, 1, -3}, "kappa = -3");
  refused({1, 1, nan}, "kappa = nan");
  refused({1e-320, 1, 1}, "m10 = ");
  refused({1, 1e308, 1}, "m01 = 1e+308");
  refused({1, 1, 1e308}, "kappa = 1e+308");
  EXPECT_EQ(Model::from({1, 0, 1}).m01, 0);
  EXPECT_EQ(Model::from({0, 1, 1}).m10, 0);
}

TEST(MooneyRivlin, from_E_and_nu_has_the_ratio_3_to_1) {
  const auto m = MooneyRivlin<double>::from(1e4, 0.45);
  EXPECT_DOUBLE_EQ(m.m10, 3 * m.m01);
}

}  // namespace
}  // namespace physgen::fem
