// Runs of bytes between any places of two arrays in one layout: what transfers of ranges are made of.
#include <chunks.h>
#include <part.h>
#include <plain_copy.h>

#include <array>

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
  ASSERT_TRUE(detail::same_records(to.array.untyped(), from.array.untyped()));
  ASSERT_TRUE(detail::same_runs(to.array.untyped(), from.array.untyped()));
  const auto any = [&](index_t end) { return std::uniform_int_distribution<index_t>(0, end)(random); };
  for (int repeat = 0; repeat < 20; ++repeat) {
    const index_t from_begin = any(250);
    const index_t count = any(250 - from_begin);
    const index_t to_begin = repeat % 2 == 0 ? from_begin : any(333 - count);  // in step, and out of step
    (void)detail::copy_plain(to.array.untyped(), to_begin, from.array.untyped(), from_begin, count, nullptr);
    std::copy_n(from.model.begin() + from_begin, count, to.model.begin() + to_begin);
    expect_sound(to.array, to.model);
  }
}

/// A part for a chunk lies in step with its array, so that whole tiles of both are one run: hundreds of objects of a
/// wide tile are one transfer for each field, not one for each 32 objects.
TYPED_TEST(PlainCopy, chunks_cover_their_range_and_begin_with_whole_tiles) {
  using Object = tissue::model::ShapesObject;
  std::mt19937 random(seed());
  const UntypedArray form = Array<Object, float, Host, TypeParam>(1).untyped();
  for (int repeat = 0; repeat < 200; ++repeat) {
    UntypedArray array = form;
    constexpr std::array<unsigned, 4> sizes{1000000, 1000000, 2 * unsigned{detail::longest_tile}, 64};
    array.size = 1 + static_cast<index_t>(random() % sizes[static_cast<std::size_t>(repeat) % 4]);
    array.padded = TypeParam::padded(array.size);
    array.pitch = TypeParam::pitch(array.size);
    array.record_bytes = repeat % 3 == 0 ? 1 << 20 : repeat % 3 == 1 ? 4000 : form.record_bytes;
    const auto begin = static_cast<index_t>(random() % static_cast<unsigned>(array.size));
    const index_t end = begin + static_cast<index_t>(random() % static_cast<unsigned>(array.size - begin + 1));
    const detail::Chunks chunks(array, begin, end, repeat % 2 == 0 ? 1 : 4);
    const UntypedArray part = detail::part_of(array, chunks.objects, SpaceKind::pinned);
    // A view of the part finds fields by the pitch of its type, where that is a constant.
    if (TypeParam::pitch(1) == TypeParam::pitch(1000000)) {
      ASSERT_EQ(part.pitch, array.pitch) << array.size << " objects";
    }
    index_t reached = begin;
    for (index_t k = 0; k < chunks.count(); ++k) {
      ASSERT_EQ(chunks.first(k), reached) << "chunk " << k << " of " << begin << " to " << end;
      ASSERT_LT(chunks.first(k), chunks.last(k));
      if (k > 0) {
        ASSERT_EQ(chunks.first(k) % chunks.tile, 0) << k;
      }
      const index_t in_part = chunks.first(k) - chunks.aligned(k);
      ASSERT_EQ(chunks.aligned(k) % padding_objects, 0);
      if (array.pitch < array.padded) {
        ASSERT_EQ(in_part % array.pitch, chunks.first(k) % array.pitch) << k;
      }
      ASSERT_LE(in_part + chunks.last(k) - chunks.first(k), part.padded);
      reached = chunks.last(k);
    }
    ASSERT_EQ(reached, end);
    // Little more than a usual chunk, or a tile of huge records, or what all objects take.
    const index_t usual = (index_t{8} << 20) + 2 * chunks.tile * array.record_bytes;
    ASSERT_LE(part.bytes(), (repeat % 2 == 0 ? 1 : 4) * usual) << array.record_bytes;
    ASSERT_LE(part.bytes(), std::max(array.bytes(), chunks.tile * array.record_bytes));
  }
}

}  // namespace
}  // namespace physgen::test
