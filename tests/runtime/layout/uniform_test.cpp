// One record for all objects.
#include <gtest/gtest.h>
#include <physgen/layout/uniform.h>

#include "layout/addresses.h"

namespace physgen::test {
namespace {

TEST(Uniform, has_one_record_whatever_the_object) {
  EXPECT_EQ(address_in<Uniform>(100, 12, 4, 0, 4, 4), 4);
  EXPECT_EQ(address_in<Uniform>(100, 12, 4, 99, 4, 4), 4);
}

TEST(Uniform, has_no_objects_side_by_side_so_packs_do_not_load_them) { EXPECT_FALSE(Uniform::contiguous(1)); }

}  // namespace
}  // namespace physgen::test
