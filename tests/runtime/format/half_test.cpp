// Halves: every pattern, rounding, and halves that are scaled by a power of two.
#include <cmath>

#include "test_objects.h"

#ifdef __SSE2__
#include <immintrin.h>
#endif

namespace physgen::test {
namespace {

using format::detail::float_to_half, format::detail::half_to_float;

/// The value of a half from its definition.
double half_by_definition(unsigned bits) {
  const int exponent = static_cast<int>(bits >> 10 & 31), mantissa = static_cast<int>(bits & 1023);
  const double sign = bits >> 15 != 0 ? -1 : 1;
  if (exponent == 31) return mantissa == 0 ? sign * INFINITY : NAN;
  return sign * (exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(1024 + mantissa, exponent - 25));
}

TEST(Half, every_pattern_means_what_ieee_754_says_and_comes_back) {
  for (unsigned bits = 0; bits < 65536; ++bits) {
    const float value = half_to_float(static_cast<std::uint16_t>(bits));
    const double expected = half_by_definition(bits);
    if (std::isnan(expected)) {
      EXPECT_TRUE(std::isnan(value)) << bits;
      EXPECT_TRUE(std::isnan(half_to_float(float_to_half(value)))) << bits;
    } else {
      ASSERT_EQ(value, expected) << bits;
      ASSERT_EQ(float_to_half(value), bits);
    }
  }
}

TEST(Half, rounds_to_the_nearest_and_ties_to_even_from_float_and_from_double) {
  std::mt19937_64 random(seed());
  const auto nearest = [](double x) {  // by looking at both neighbours
    unsigned low = 0, high = 0x7c00;
    while (high - low > 1) {
      const unsigned middle = (low + high) / 2;
      (half_by_definition(middle) <= x ? low : high) = middle;
    }
    const double below = half_by_definition(low);
    const double above = high == 0x7c00 ? 65536 : half_by_definition(high);  // where the next one would be
    if (x - below != above - x) return x - below < above - x ? low : high;
    return low % 2 == 0 ? low : high;
  };
  std::uniform_real_distribution<double> exponent(-27, 17);
  for (int sample = 0; sample < 200000; ++sample) {
    double x = std::exp2(exponent(random));
    if (sample % 3 == 0) {  // at and around a tie
      const unsigned at = static_cast<unsigned>(random() % 0x7bff);
      x = (half_by_definition(at) + half_by_definition(at + 1)) / 2;
      if (sample % 2 == 0) x = std::nextafter(x, sample % 4 == 0 ? 0.0 : 1e9);
    }
    const std::uint16_t from_double = format::Half<>::encode<double>(x);
    ASSERT_EQ(from_double, nearest(x)) << x;
    const auto single = static_cast<float>(x);
    ASSERT_EQ(format::Half<>::encode<float>(-single), nearest(single) | 0x8000U) << single;
  }
}

#ifdef __SSE2__
TEST(Half, keeps_its_smallest_numbers_where_subnormal_floats_are_flushed_to_zero) {
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | 0x8040U);  // flush results to zero, and take subnormal operands as zero
  for (unsigned bits = 1; bits < 0x400; ++bits) {
    const float value = half_to_float(static_cast<std::uint16_t>(bits));
    EXPECT_EQ(value, static_cast<float>(bits) * 0x1p-24F);
    EXPECT_EQ(float_to_half(-value), bits | 0x8000U);
  }
  _mm_setcsr(before);
}
#endif

TEST(Half, with_an_exponent_moves_its_range_by_a_power_of_two) {
  using Scaled = format::Half<5>;
  EXPECT_EQ(Scaled::decode<float>(Scaled::encode<float>(2e6F)), 1953 * 32 * 32);  // halves near 62500 are 32 apart
  EXPECT_EQ(Scaled::decode<float>(Scaled::encode<float>(3e6F)), INFINITY);
  std::mt19937 random(seed());
  std::uniform_real_distribution<float> value(1.0F, 2e6F);
  for (int sample = 0; sample < 10000; ++sample) {
    const float x = value(random);
    ASSERT_LE(std::abs(Scaled::decode<float>(Scaled::encode<float>(x)) - x), 0x1p-11F * x);
  }
}

}  // namespace
}  // namespace physgen::test
