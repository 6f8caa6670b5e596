// sin, cos and tan of packs of doubles, next to multiples of pi/2 above all, where an argument's own distance from them
// is all that the result has.
#include <gtest/gtest.h>
#include <physgen/simd/simd_access.h>

#include <array>
#include <cfloat>
#include <cmath>

#include "test_objects.h"

namespace physgen::test {
namespace {

constexpr long double half_pi = 1.57079632679489661923132169163975144L;

/// The distance of `got` from `exact`, in units in the last place of doubles.
double error_in_ulp(double got, long double exact) {
  const int exponent = std::ilogb(exact);
  return static_cast<double>(std::abs(static_cast<long double>(got) - exact) / std::ldexp(1.0L, exponent - 52));
}

template <class S>
class Trigonometry : public testing::Test {
 protected:
  /// Compares the functions of x, which stands beside other arguments in a pack.
  void check(double x) {
    std::array<double, S::size> arguments;
    for (double& other : arguments) other = std::uniform_real_distribution<double>(-4, 4)(generator);
    arguments[lane] = x;
    const S pack = S::load_unaligned(arguments.data());
    const auto exact = static_cast<long double>(x);
    EXPECT_LE(error_in_ulp(sin(pack).get(lane), std::sin(exact)), 2.4) << "sin " << x;
    EXPECT_LE(error_in_ulp(cos(pack).get(lane), std::cos(exact)), 2.4) << "cos " << x;
    EXPECT_LE(error_in_ulp(tan(pack).get(lane), std::tan(exact)), 3.3) << "tan " << x;
    lane = (lane + 1) % S::size;
  }
  std::mt19937_64 generator{seed()};
  std::size_t lane = 0;
};
using Packs = testing::Types<Batch<double>, batch_t<double, 2>, batch_t<double, 4>>;
TYPED_TEST_SUITE(Trigonometry, Packs);

TYPED_TEST(Trigonometry, of_doubles_holds_next_to_multiples_of_half_pi) {
  if (LDBL_MANT_DIG < 64) GTEST_SKIP() << "long double is double here";
  for (const double x : {M_PI, M_PI / 2, 45.553093477052002}) this->check(x);
  for (int k = 1; k < 20000; ++k) {
    const auto x = static_cast<double>(half_pi * k);
    this->check(x);
    this->check(-std::nextafter(x, 0.0));
    this->check(std::nextafter(x, HUGE_VAL));
  }
  for (int k = 0; k < 20000; ++k) {
    const auto any = std::uniform_int_distribution<std::int64_t>(1, std::int64_t{1} << 45)(this->generator);
    this->check(static_cast<double>(half_pi * static_cast<long double>(any)));
  }
}

TYPED_TEST(Trigonometry, of_doubles_holds_for_arguments_of_any_size) {
  if (LDBL_MANT_DIG < 64) GTEST_SKIP() << "long double is double here";
  for (int k = 0; k < 50000; ++k) {
    const double size = std::uniform_real_distribution<double>(-30, 300)(this->generator);
    this->check(std::uniform_real_distribution<double>(-1, 1)(this->generator) * std::pow(10, size));
    this->check(std::uniform_real_distribution<double>(-100, 100)(this->generator));
  }
  for (const double none : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
    EXPECT_TRUE(std::isnan(sin(TypeParam(none)).get(0)) && std::isnan(cos(TypeParam(none)).get(0)) &&
                std::isnan(tan(TypeParam(none)).get(0)));
  }
}

TYPED_TEST(Trigonometry, of_a_lane_has_the_same_bits_beside_any_other) {
  for (int k = 0; k < 20000; ++k) {
    const double size = std::uniform_real_distribution<double>(-3, 9)(this->generator);
    const double x = std::uniform_real_distribution<double>(-1, 1)(this->generator) * std::pow(10, size);
    std::array<double, TypeParam::size> arguments;
    for (const double other : {0.1, 1.2, 30.0, 1e5, 1e12}) {
      arguments.fill(other);
      arguments[0] = x;
      const auto mixed = TypeParam::load_unaligned(arguments.data());
      ASSERT_EQ(sin(mixed).get(0), sin(TypeParam(x)).get(0)) << x << " beside " << other;
      ASSERT_EQ(tan(mixed).get(0), tan(TypeParam(x)).get(0)) << x << " beside " << other;
    }
  }
}

}  // namespace
}  // namespace physgen::test
