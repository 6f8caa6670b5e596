// Arrays of structs.
#include <gtest/gtest.h>

#include "layout/addresses.h"

namespace physgen::test {
namespace {

TEST(Aos, puts_one_record_after_the_other) {
  EXPECT_EQ(address_in<Aos>(100, 12, 4, 0, 0, 4), 0);
  EXPECT_EQ(address_in<Aos>(100, 12, 4, 2, 4, 4), 28);  // the second of three floats of object 2
  EXPECT_EQ(address_in<Aos>(100, 12, 4, 99, 8, 4), 1196);
}

TEST(Aos, pads_records_to_their_alignment_alone) {
  EXPECT_EQ(Aos::record_bytes(12, 4), 12);
  EXPECT_EQ(Aos::record_bytes(12, 8), 16);
  EXPECT_EQ(address_in<Aos>(10, 12, 8, 3, 8, 4), 56);
}

TEST(Aos, has_no_two_objects_side_by_side) {
  EXPECT_TRUE(Aos::contiguous(1));
  EXPECT_FALSE(Aos::contiguous(2));
  EXPECT_EQ(Aos::padded(33), 64);
}

}  // namespace
}  // namespace physgen::test
