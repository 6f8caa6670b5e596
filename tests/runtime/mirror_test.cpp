// Copies of ranges, and mirrors both of whose sides lie in ordinary host memory.
#include "mirror_checks.h"

namespace physgen::test {
namespace {

template <class L>
class HostMirror : public ::testing::Test {};
TYPED_TEST_SUITE(HostMirror, AllLayouts, LayoutName);

TYPED_TEST(HostMirror, copies_of_ranges_move_their_objects_and_no_others) { check_ranges<Host, TypeParam>(); }
TYPED_TEST(HostMirror, copies_ranges_between_arrays_of_different_sizes) {
  check_ranges_of_different_sizes<Host, TypeParam>();
}
TYPED_TEST(HostMirror, moves_only_the_blocks_that_changed) {
  check_mirror_moves_only_what_changed<Host, TypeParam, TypeParam>();
  check_mirror_moves_only_what_changed<Host, TypeParam, AosPadded>();
}
TYPED_TEST(HostMirror, refuses_a_block_that_changed_on_both_sides) {
  check_mirror_refuses_a_block_that_changed_on_both_sides<Host, TypeParam>();
}
TYPED_TEST(HostMirror, reads_what_was_written_last_under_random_use) {
  check_mirror_under_random_use<Host, TypeParam>();
}
TYPED_TEST(HostMirror, lets_its_objects_change_topology) {
  check_mirror_of_objects_that_change_topology<Host, TypeParam>();
}

TEST(Mirror, begins_with_initial_values_that_need_no_transfer) {
  Mirror<elasticity::TetArray<float>, elasticity::TetArray<float, Host, Soa>> mirror(100);
  EXPECT_EQ(mirror.read_device().size(), 100);
  EXPECT_EQ(mirror.read_host().size(), 100);
  EXPECT_EQ(mirror.bytes_moved(), 0);
  (void)mirror.write_host();
  const auto copied = mirror;
  const auto moved = std::move(mirror);
  EXPECT_EQ(copied.size(), 100);
  EXPECT_EQ(moved.size(), 100);
  EXPECT_EQ(mirror.size(), 0);  // NOLINT: what is left of it is the empty mirror
}

}  // namespace
}  // namespace physgen::test
