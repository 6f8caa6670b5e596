// Round trips, conversions and resize in ordinary host memory.
#include "round_trip_checks.h"

namespace physgen::test {
namespace {

template <class L>
class HostRoundTrip : public ::testing::Test {};
TYPED_TEST_SUITE(HostRoundTrip, AllLayouts, LayoutName);

TYPED_TEST(HostRoundTrip, returns_every_object_bit_for_bit) {
  check_round_trips_of_all_object_types<Host, TypeParam>();
}
TYPED_TEST(HostRoundTrip, rounds_double_to_the_nearest_float) { check_conversion_of_precision<Host, TypeParam>(); }
TYPED_TEST(HostRoundTrip, converts_directly_to_every_layout) { check_all_pairs_from<Host, TypeParam>(); }
TYPED_TEST(HostRoundTrip, resize_keeps_objects_and_initialises_new_ones) { check_resize<Host, TypeParam>(); }

}  // namespace
}  // namespace physgen::test
