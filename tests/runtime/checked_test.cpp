// What a checked build reports. This program is compiled with PHYSGEN_CHECKED.
#include <physgen/parallel_for.h>

#include "test_objects.h"

namespace physgen::test {
namespace {

using elasticity::NodePositionArray;
using elasticity::NodePositionView;

TEST(CheckedView, reports_an_index_out_of_range_with_object_type_and_size) {
  NodePositionArray<float> array(5);
  const auto view = array.view();
  EXPECT_EQ(message_of([&] { (void)view[5]; }), "physgen: elasticity::NodePosition: object 5 of an array of 5");
  EXPECT_EQ(message_of([&] { (void)view[-1]; }), "physgen: elasticity::NodePosition: object -1 of an array of 5");
}

TEST(CheckedView, reports_a_null_view) {
  const NodePositionView<float, Aosoa<16>> view;
  EXPECT_NE(message_of([&] { (void)view[0]; }), "nothing was thrown");
}

TEST(CheckedView, reports_device_memory_used_on_the_host) {
  std::vector<std::byte> memory(4096);
  const NodePositionView<float, Aosoa<32>> view(memory.data(), 5, 32, SpaceKind::cuda);
  EXPECT_EQ(
      message_of([&] { (void)view[0]; }),
      "physgen: elasticity::NodePosition: a view of cuda memory is used on the host; copy the array to Host first");
}

TEST(CheckedView, reports_out_of_packs_and_threads) {
  NodePositionArray<float> array(20000);
  const auto view = array.view();
  EXPECT_THROW(parallel_for(Host{}, 20001, [=](index_t i) { (void)view[i]; }), Error);
  EXPECT_THROW((void)view[Pack<8>{20000}], Error);
  EXPECT_NO_THROW((void)view[Pack<8>{19992}]);
  EXPECT_THROW((void)view[Pack<8>{4}], Error) << "a pack that does not start at a multiple of its width";
}

TEST(CheckedView, reports_a_gathered_index_out_of_range) {
  NodePositionArray<float> array(10);
  const auto view = array.view();
  const batch_t<std::int32_t, native_lanes<float>> index(10);
  EXPECT_THROW((void)view[index], Error);
}

}  // namespace
}  // namespace physgen::test
