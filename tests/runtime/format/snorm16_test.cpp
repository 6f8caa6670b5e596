// Equal steps over a range, in 16 bits.
#include <cmath>

#include "test_objects.h"

namespace physgen::test {
namespace {

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

}  // namespace
}  // namespace physgen::test
