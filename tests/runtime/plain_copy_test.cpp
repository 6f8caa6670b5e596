// Runs of bytes between any places of two arrays in one layout: what transfers of ranges are made of.
#include <plain_copy.h>

#include "topology_checks.h"

namespace physgen::test {
namespace {

template <class L>
class PlainCopy : public ::testing::Test {};
TYPED_TEST_SUITE(PlainCopy, AllLayouts, LayoutName);

TYPED_TEST(PlainCopy, moves_objects_between_any_places) {
  using Object = tissue::model::ShapesObject;
  std::mt19937 random(seed());
  Random<Array<Object, float, Host, TypeParam>> to(333, random);
  const Random<Array<Object, float, Host, TypeParam>> from(250, random);
  ASSERT_TRUE(detail::same_records(to.array.storage(), from.array.storage()));
  ASSERT_TRUE(detail::same_runs(to.array.storage(), from.array.storage()));
  const auto any = [&](index_t end) { return std::uniform_int_distribution<index_t>(0, end)(random); };
  for (int repeat = 0; repeat < 20; ++repeat) {
    const index_t from_begin = any(250);
    const index_t count = any(250 - from_begin);
    const index_t to_begin = repeat % 2 == 0 ? from_begin : any(333 - count);  // in step, and out of step
    (void)detail::copy_plain(to.array.storage(), to_begin, from.array.storage(), from_begin, count, nullptr);
    std::copy_n(from.model.begin() + from_begin, count, to.model.begin() + to_begin);
    expect_sound(to.array, to.model);
  }
}

}  // namespace
}  // namespace physgen::test
