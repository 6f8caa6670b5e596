// UntypedArray formats: each number of 16 bits, rounding, and arrays whose fields are stored otherwise than computed.
#include <physgen/parallel_for.h>

#include <cmath>

#include "format_checks.h"

namespace physgen::test {
namespace {

using format::detail::bfloat16_to_float, format::detail::float_to_bfloat16, format::detail::float_to_half,
    format::detail::half_to_float;

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

TEST(Bfloat16, rounds_to_the_nearest_keeps_nan_and_holds_all_of_float) {
  std::mt19937 random(seed());
  for (int sample = 0; sample < 200000; ++sample) {
    const auto x = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    const float back = bfloat16_to_float(float_to_bfloat16(x));
    if (std::isnan(x)) {
      ASSERT_TRUE(std::isnan(back));
    } else if (std::abs(x) < 0x1.ffp127F && std::abs(x) > 0x1p-126F) {
      ASSERT_LE(std::abs(back - x), 0x1p-8 * std::abs(x)) << x;
    }
  }
  EXPECT_EQ(bfloat16_to_float(float_to_bfloat16(1 + 0x1p-8F)), 1.0F);             // a tie, to even
  EXPECT_EQ(bfloat16_to_float(float_to_bfloat16(1 + 3 * 0x1p-8F)), 1 + 0x1p-6F);  // the other way
  EXPECT_EQ(format::Bfloat16::encode<double>(1 + 0x1p-8 + 0x1p-40), 0x3f81);      // no tie, seen from double
}

TEST(Snorm16, holds_its_range_in_equal_steps_and_nan) {
  using Steps = format::Snorm16<format::Interval{-3.0, 5.0}>;
  std::mt19937 random(seed());
  std::uniform_real_distribution<double> value(-3, 5);
  for (int sample = 0; sample < 100000; ++sample) {
    const double x = value(random);
    ASSERT_LE(std::abs(Steps::decode<double>(Steps::encode<double>(x)) - x), 8.0 / 131068 * (1 + 1e-9)) << x;
  }
  for (int step = -32767; step <= 32767; ++step) {
    ASSERT_EQ(Steps::encode<float>(Steps::decode<float>(static_cast<std::int16_t>(step))), step);
  }
  EXPECT_EQ(Steps::decode<double>(Steps::encode<double>(5)), 5);
  EXPECT_EQ(Steps::decode<double>(Steps::encode<double>(1e30)), 5);
  EXPECT_EQ(Steps::decode<double>(Steps::encode<double>(-INFINITY)), -3);
  EXPECT_TRUE(std::isnan(Steps::decode<float>(Steps::encode<float>(NAN))));
}

template <class Steps>
struct StepPositions : elasticity::NodePositionFormats<Host> {
  using x = Steps;
};

/// Ranges whose steps, or their inverse, leave the numbers of the type computed with.
template <format::Interval kRange, class Real>
void check_equal_steps_over() {
  using Steps = format::Snorm16<kRange>;
  std::mt19937 random(seed());
  using Formats = StepPositions<Steps>;
  using Position = elasticity::NodePositionObject;
  constexpr index_t n = 1000;
  Array<Position, Real, Host, Soa, Formats> viewed(n), copied(n);
  static_assert(decltype(viewed)::record_bytes == 6);
  Array<Position, Real, Host, Aos> values(n), back(n);
  const double middle = kRange.low / 2 + kRange.high / 2, half = kRange.high / 2 - kRange.low / 2;
  const double rounding = std::numeric_limits<Real>::epsilon() * std::max(std::abs(kRange.low), std::abs(kRange.high)) +
                          std::numeric_limits<Real>::denorm_min();
  for (index_t i = 0; i < n; ++i) {
    for (int k = 0; k < 3; ++k) {
      values.putdata(i, k, middle + half * std::uniform_real_distribution<double>(-0.999, 0.999)(random));
    }
    viewed.view().put(i, values.view().get(i));
  }
  copy(copied, values);
  copy(back, viewed);
  for (index_t i = 0; i < n; ++i) {
    for (int k = 0; k < 3; ++k) {
      ASSERT_NEAR(back.getdata(i, k), values.getdata(i, k), half / 65534 * (1 + 1e-6) + rounding) << i;
      ASSERT_EQ(copied.getdata(i, k), viewed.getdata(i, k)) << "copies and accessors differ at object " << i;
    }
    ASSERT_EQ(viewed.const_view().get(i).x, back.const_view().get(i).x) << i;
  }
}

TEST(Snorm16, holds_the_tiniest_and_the_largest_ranges) {
  check_equal_steps_over<format::Interval{0, 2e-35}, float>();
  check_equal_steps_over<format::Interval{-1e-37, 3e-38}, float>();
  check_equal_steps_over<format::Interval{-3e38, 3.3e38}, float>();
  check_equal_steps_over<format::Interval{2e38, 3.3e38}, float>();
  check_equal_steps_over<format::Interval{0, 2e-35}, double>();
  check_equal_steps_over<format::Interval{-1e-306, 3e-307}, double>();
  check_equal_steps_over<format::Interval{-1.7e308, 1.6e308}, double>();
}

TEST(ScaledHalf, moves_its_range_by_a_power_of_two) {
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

template <class Layout>
class FormatsOver : public ::testing::Test {};
TYPED_TEST_SUITE(FormatsOver, AllLayouts, LayoutName);

TYPED_TEST(FormatsOver, objects_of_mixed_sizes_come_back_within_the_errors_of_their_formats) {
  for (const index_t n : {0, 1, 31, 33, 1000}) check_mixed_round_trip<Host, TypeParam>(n);
}

TYPED_TEST(FormatsOver, rotations_come_back_from_quaternions) {
  check_rotations<Host, TypeParam, format::Native>(257, 6e-7);
  check_rotations<Host, TypeParam, format::Half<>>(257, 2e-3);
  check_rotations<Host, TypeParam, format::Snorm16<format::Interval{-1.0, 1.0}>>(257, 9e-5);
  check_rotations<Host, TypeParam, format::Bfloat16>(257, 1.6e-2);
}

TYPED_TEST(FormatsOver, views_read_and_write_single_objects_and_packs_alike) {
  std::mt19937 random(seed());
  std::uniform_real_distribution<float> value(-2.0F, 2.0F);
  constexpr index_t n = 96;
  Array<elasticity::StressDerivativeObject, float, Host, TypeParam, MixedDerivative> one_by_one(n), packs(n);
  elasticity::StressDerivativeArray<float, Host, Aosoa<16>> source(n);
  for (index_t i = 0; i < n; ++i) {
    for (int k = 0; k < source.elements; ++k) source.putdata(i, k, value(random));
  }
  const auto from = source.const_view();
  for (index_t i = 0; i < n; ++i) one_by_one.view().put(i, from.get(i));
  constexpr int W = native_lanes<float>;
  for (index_t i = 0; i < n; i += W) packs.view().put(Pack<W>{i}, from.get(Pack<W>{i}));
  Array<elasticity::StressDerivativeObject, float, Host, Aos, MixedDerivative> a(n), b(n), copied(n);
  copy(a, one_by_one);
  copy(b, packs);
  copy(copied, source);
  EXPECT_EQ(count_different(a, b), 0);
  EXPECT_EQ(count_different(a, copied), 0);  // accessors and copies round alike
  for (index_t i = 0; i < n; i += W) {
    const auto read = packs.const_view().get(Pack<W>{i});
    for (int l = 0; l < W; ++l) {
      const auto single = one_by_one.const_view().get(i + l);
      ASSERT_EQ(read.x1111.get(static_cast<std::size_t>(l)), single.x1111);
      ASSERT_EQ(read.x3322.get(static_cast<std::size_t>(l)), single.x3322);
      ASSERT_EQ(read.x3311.get(static_cast<std::size_t>(l)), single.x3311);
    }
  }
}

TEST(Formats, an_element_is_assigned_added_to_and_read_as_a_number) {
  Array<elasticity::StressDerivativeObject, float, Host, Aosoa<16>, MixedDerivative> array(5);
  const auto view = array.view();
  view[3].x1111() = 1.5F;
  view[3].x1111() += 0.25F;
  view[3].x1111() *= 2.0F;
  const float read = view[3].x1111();
  EXPECT_EQ(read, 3.5F);
  view[4].x1111() = view[3].x1111();
  EXPECT_EQ(array.getdata(4, 0), 3.5);
  view[3].x2222() = 7.0F;  // stored as computed: a plain reference
  EXPECT_EQ(&view[3].x2222(), &view[3].x2222());
}

TEST(Formats, a_record_is_as_small_as_its_elements) {
  using Mixed = Array<elasticity::StressDerivativeObject, float, Host, Soa, MixedDerivative>;
  EXPECT_EQ(Mixed::record_bytes, 8 + 7 * 4 + 4 * 2);
  using Compact = Array<elasticity::DeformationSvdObject, float, Host, Soa,
                        CompactSvd<format::Snorm16<format::Interval{-1.0, 1.0}>>>;
  EXPECT_EQ(Compact::record_bytes, 8 * 2 + 3 * 2);
  EXPECT_EQ(Compact::elements, 21);
}

TEST(Formats, a_new_rotation_stored_as_a_quaternion_is_the_identity) {
  Array<elasticity::DeformationSvdObject, float, Host, Soa, CompactSvd<format::Half<>>> array(3);
  EXPECT_EQ(array.view().get(2).U, Eigen::Matrix3f::Identity());
  EXPECT_EQ(array.getdata(1, 4), 1);
  EXPECT_NE(message_of([&] { array.putdata(1, 4, 2); }).find("stored as a quaternion"), std::string::npos);
}

TEST(Formats, what_a_copy_loses_is_counted_with_its_place) { check_losses<Host>(); }

TEST(Formats, copies_between_arrays_that_share_memory_or_have_none_are_refused) {
  elasticity::StressDerivativeArray<float, Host, Soa> array(100), other(100);
  for (int k = 0; k < array.elements; ++k) array.putdata(7, k, k + 1);
  UntypedArray shifted = array.untyped();
  shifted.base += 64;
  EXPECT_NE(message_of([&] { copy(shifted, array.untyped()); }).find("share memory"), std::string::npos);
  UntypedArray nowhere = other.untyped();
  nowhere.base = nullptr;
  EXPECT_NE(message_of([&] { copy(array.untyped(), nowhere); }).find("no memory (null)"), std::string::npos);
  for (int k = 0; k < array.elements; ++k) EXPECT_EQ(array.getdata(7, k), k + 1);
}

}  // namespace
}  // namespace physgen::test
