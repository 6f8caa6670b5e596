// The upper halves of floats.
#include <bit>
#include <cmath>

#include "test_objects.h"

namespace physgen::test {
namespace {

using format::detail::bfloat16_to_float, format::detail::float_to_bfloat16;

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

}  // namespace
}  // namespace physgen::test
