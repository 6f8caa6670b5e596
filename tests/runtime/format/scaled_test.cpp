// Numbers that are stored in another unit, or as their distance from a centre.
#include <cmath>

#include "test_objects.h"

namespace physgen::test {
namespace {

TEST(Scaled, keeps_another_unit_in_a_float) {
  using Thousands = format::Scaled<format::Float32, format::Affine{.scale = 1000}>;
  EXPECT_EQ(Thousands::encode<double>(2500.0), 2.5F);
  EXPECT_EQ(Thousands::decode<double>(2.5F), 2500.0);
}

TEST(Scaled, keeps_temperatures_to_a_part_of_their_distance_from_the_centre) {
  using Temperature = format::Scaled<format::Half<>, format::Affine{.centre = 300}>;
  std::mt19937 random(seed());
  std::uniform_real_distribution<double> value(250, 350);
  for (int sample = 0; sample < 10000; ++sample) {
    const double kelvin = value(random);
    const double error = std::abs(Temperature::decode<double>(Temperature::encode<double>(kelvin)) - kelvin);
    ASSERT_LE(error, 0x1p-11 * std::abs(kelvin - 300) + 1e-7) << kelvin;
  }
  EXPECT_EQ(Temperature::decode<double>(Temperature::encode<double>(300)), 300);
}

}  // namespace
}  // namespace physgen::test
