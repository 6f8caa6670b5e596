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
TYPED_TEST(HostMirror, refuses_objects_that_changed_on_both_sides) {
  check_mirror_refuses_objects_that_changed_on_both_sides<Host, TypeParam>();
}
TYPED_TEST(HostMirror, reads_what_was_written_last_under_random_use) {
  check_mirror_under_random_use<Host, TypeParam>();
}
TYPED_TEST(HostMirror, lets_its_objects_change_topology) {
  check_mirror_of_objects_that_change_topology<Host, TypeParam>();
}

TYPED_TEST(HostMirror, keeps_what_nobody_wrote_whatever_the_formats) {
  check_mirrors_of_different_formats<Host, TypeParam>();
}

/// A set of ranges against one flag for each object.
TEST(ObjectSet, is_a_set_of_objects) {
  constexpr index_t n = 120;
  std::mt19937 random(seed());
  detail::ObjectSet set;
  std::vector<bool> model(n, false);
  for (int step = 0; step < 3000; ++step) {
    const auto begin = static_cast<index_t>(random() % n);
    const index_t end = std::min(n, begin + 1 + static_cast<index_t>(random() % (step % 5 == 0 ? 60 : 4)));
    const bool added = random() % 2 == 0;
    added ? set.add(begin, end) : set.remove(begin, end);
    std::fill(model.begin() + begin, model.begin() + end, added);
    const auto low = static_cast<index_t>(random() % n), high = low + static_cast<index_t>(random() % (n - low + 1));
    std::vector<detail::ObjectRange> expected;
    for (index_t i = low; i < high; ++i) {
      if (!model[static_cast<std::size_t>(i)]) continue;
      if (!expected.empty() && expected.back().end == i) {
        ++expected.back().end;
      } else {
        expected.push_back({i, i + 1});
      }
    }
    ASSERT_EQ(set.in(low, high), expected) << "step " << step;
  }
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
