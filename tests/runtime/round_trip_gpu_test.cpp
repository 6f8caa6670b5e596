// Round trips, conversions and resize in pinned and CUDA memory: the checks of the host test on a device.
#include "gpu_fixture.h"
#include "round_trip_checks.h"

namespace physgen::test {
namespace {

template <class L>
class CudaRoundTrip : public GpuTest {};
TYPED_TEST_SUITE(CudaRoundTrip, AllLayouts, LayoutName);

TYPED_TEST(CudaRoundTrip, returns_every_float_object_bit_for_bit) {
  check_round_trips_of_all_object_types<float, Cuda, TypeParam>();
}
TYPED_TEST(CudaRoundTrip, returns_every_double_object_bit_for_bit) {
  check_round_trips_of_all_object_types<double, Cuda, TypeParam>();
}
TYPED_TEST(CudaRoundTrip, passes_pinned_memory_unchanged) {
  check_round_trips_of_all_object_types<float, PinnedHost, TypeParam>();
}
TYPED_TEST(CudaRoundTrip, rounds_double_to_the_nearest_float) { check_conversion_of_precision<Cuda, TypeParam>(); }
TYPED_TEST(CudaRoundTrip, converts_directly_to_every_layout) { check_all_pairs_from<Cuda, TypeParam>(); }
TYPED_TEST(CudaRoundTrip, resize_keeps_objects_and_initialises_new_ones) { check_resize<Cuda, TypeParam>(); }

class CudaArray : public GpuTest {};

TEST_F(CudaArray, refuses_more_memory_than_the_device_has_and_stays_as_it_was) {
  Array<elasticity::StressDerivativeObject, float, Cuda, Aosoa<32>> array(10);
  array.putdata(7, 3, 2.5);
  try {
    array.resize(index_t{1} << 40);
    FAIL() << "an array of 48 TiB was made";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("elasticity::StressDerivative[1099511627776]"), std::string::npos)
        << error.what();
    EXPECT_NE(std::string(error.what()).find("cudaErrorMemoryAllocation"), std::string::npos) << error.what();
  }
  EXPECT_EQ(array.size(), 10);
  EXPECT_EQ(array.getdata(7, 3), 2.5);
}

}  // namespace
}  // namespace physgen::test
