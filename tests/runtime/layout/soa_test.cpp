// Structs of arrays.
#include <gtest/gtest.h>

#include "layout/addresses.h"

namespace physgen::test {
namespace {

TEST(Soa, puts_equal_elements_of_all_objects_side_by_side) {
  EXPECT_EQ(address_in<Soa>(33, 12, 4, 32, 0, 4), 128);
  EXPECT_EQ(address_in<Soa>(33, 12, 4, 0, 4, 4), 256);  // the second channel, behind 64 floats of the first
  EXPECT_EQ(address_in<Soa>(33, 12, 4, 32, 8, 4), 640);
}

TEST(Soa, begins_no_two_channels_a_multiple_of_512_objects_apart) {
  EXPECT_EQ(Soa::pitch(511), 544);
  EXPECT_EQ(Soa::pitch(512), 544);
  EXPECT_EQ(Soa::pitch(513), 544);
  EXPECT_EQ(Soa::pitch(0), 0);
}

TEST(Soa, has_all_objects_side_by_side_and_no_padding_of_records) {
  EXPECT_TRUE(Soa::contiguous(16));
  EXPECT_EQ(Soa::record_bytes(12, 8), 12);
}

}  // namespace
}  // namespace physgen::test
