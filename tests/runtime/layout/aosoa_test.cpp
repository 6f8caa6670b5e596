// Tiles of W objects, a struct of arrays inside each.
#include <gtest/gtest.h>

#include "layout/addresses.h"

namespace physgen::test {
namespace {

TEST(Aosoa, puts_equal_elements_of_a_tile_side_by_side) {
  EXPECT_EQ(address_in<Aosoa<4>>(100, 12, 4, 0, 4, 4), 16);  // behind the first elements of objects 0 to 3
  EXPECT_EQ(address_in<Aosoa<4>>(100, 12, 4, 3, 4, 4), 28);
  EXPECT_EQ(address_in<Aosoa<4>>(100, 12, 4, 4, 0, 4), 48);  // the next tile
  EXPECT_EQ(address_in<Aosoa<4>>(100, 12, 4, 5, 8, 4), 84);
}

TEST(Aosoa, mixes_sizes_without_padding) {
  // A double and a float: the float of object 3 lies behind two doubles of the tile 2, 3 and one float.
  EXPECT_EQ(address_in<Aosoa<2>>(100, 12, 8, 3, 8, 4), 24 + 16 + 4);
  EXPECT_EQ(Aosoa<32>::record_bytes(12, 8), 12);
}

TEST(Aosoa, holds_whole_tiles) {
  EXPECT_EQ(Aosoa<64>::padded(65), 128);
  EXPECT_EQ(Aosoa<4>::padded(5), 32);  // whole packs at least
  EXPECT_TRUE(Aosoa<32>::contiguous(16));
  EXPECT_FALSE(Aosoa<4>::contiguous(8));
}

}  // namespace
}  // namespace physgen::test
