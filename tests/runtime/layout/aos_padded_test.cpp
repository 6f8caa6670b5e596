// Arrays of structs whose records are multiples of 16 bytes.
#include <gtest/gtest.h>

#include "layout/addresses.h"

namespace physgen::test {
namespace {

TEST(AosPadded, begins_every_record_at_a_multiple_of_16_bytes) {
  EXPECT_EQ(AosPadded::record_bytes(12, 4), 16);
  EXPECT_EQ(AosPadded::record_bytes(16, 8), 16);
  EXPECT_EQ(AosPadded::record_bytes(36, 4), 48);
  EXPECT_EQ(address_in<AosPadded>(100, 12, 4, 2, 4, 4), 36);
}

TEST(AosPadded, keeps_a_larger_alignment) { EXPECT_EQ(AosPadded::record_bytes(2, 256), 256); }

}  // namespace
}  // namespace physgen::test
