// Elements that are stored as they are computed, and as float or double whatever is computed.
#include "test_objects.h"

namespace physgen::test {
namespace {

TEST(Native, is_the_number_itself_and_its_reference_is_plain) {
  elasticity::NodePositionArray<double, Host, Soa> positions(3);
  positions.view()[2].x()[1] = 0.1;
  static_assert(std::is_same_v<decltype(positions.view()[2].x()[1]), double&>);
  EXPECT_EQ(positions.getdata(2, 1), 0.1);
  EXPECT_EQ(format::Native::decode<double>(format::Native::encode<double>(0.1)), 0.1);
}

TEST(Float32, rounds_doubles_once_and_keeps_floats) {
  EXPECT_EQ(format::Float32::decode<double>(format::Float32::encode<double>(0.1)), double{0.1F});
  EXPECT_EQ(format::Float32::decode<float>(format::Float32::encode<float>(0.1F)), 0.1F);
  EXPECT_EQ(format::Float32::encode<double>(1 + 0x1p-24), 1.0F);              // a tie, to even
  EXPECT_EQ(format::Float32::encode<double>(1 + 3 * 0x1p-24), 1 + 0x1p-22F);  // the other way
}

TEST(Float64, keeps_every_float_and_double) {
  EXPECT_EQ(format::Float64::decode<double>(format::Float64::encode<double>(0.1)), 0.1);
  EXPECT_EQ(format::Float64::decode<float>(format::Float64::encode<float>(0.1F)), 0.1F);
  EXPECT_EQ(sizeof(format::Float64::Stored<float>), 8U);
}

}  // namespace
}  // namespace physgen::test
