// Round trips, conversions and resize in pinned and CUDA memory: the checks of the host test on a device.
#include <physgen/cuda/check.h>
#include <physgen/gather.h>

#include "gpu_fixture.h"
#include "round_trip_checks.h"

namespace physgen::test {
namespace {

template <class L>
class CudaRoundTrip : public GpuTest {};
TYPED_TEST_SUITE(CudaRoundTrip, AllLayouts, LayoutName);

TYPED_TEST(CudaRoundTrip, returns_every_object_bit_for_bit) {
  check_round_trips_of_all_object_types<Cuda, TypeParam>();
}
TYPED_TEST(CudaRoundTrip, passes_pinned_memory_unchanged) {
  check_round_trips_of_all_object_types<PinnedHost, TypeParam>();
}
TYPED_TEST(CudaRoundTrip, rounds_double_to_the_nearest_float) { check_conversion_of_precision<Cuda, TypeParam>(); }
TYPED_TEST(CudaRoundTrip, converts_directly_to_every_layout) { check_all_pairs_from<Cuda, TypeParam>(); }
TYPED_TEST(CudaRoundTrip, resize_keeps_objects_and_initialises_new_ones) { check_resize<Cuda, TypeParam>(); }

// Through pinned memory and a stream of its own, in every direction, ending where it began.
TYPED_TEST(CudaRoundTrip, passes_through_pinned_memory_in_a_stream) {
  cudaStream_t stream = nullptr;
  cuda::check(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), "creating a stream");
  std::mt19937 random(seed());
  using Object = elasticity::RestShapeObject;
  const index_t n = 4099;
  Array<Object, float, Host, Aos> source(n);
  randomise(source, random);
  Array<Object, float, PinnedHost, TypeParam> pinned(n);
  copy(pinned, source);
  Array<Object, float, Cuda, AosPadded> padded(n);
  Array<Object, double, Cuda, TypeParam> wide(n);
  Array<Object, float, PinnedHost, Soa> back(n);
  poison(back);
  copy(padded, pinned, stream);
  copy(wide, padded, stream);
  copy(back, wide, stream);
  synchronize(stream);
  Array<Object, float, Host, Aos> result(n);
  poison(result);
  copy(result, back);
  EXPECT_EQ(count_different(source, result), 0);
  cudaStreamDestroy(stream);
}

TYPED_TEST(CudaRoundTrip, keeps_the_padding_of_host_arrays_initialised) {
  for (const index_t n : {32, 33}) {
    Array<elasticity::NodePositionObject, double, Cuda, TypeParam> device(n);
    Array<elasticity::NodePositionObject, float, Host, AosPadded> host(n);
    copy(host, device);
    synchronize();
    for (index_t byte = 0; byte < host.bytes(); ++byte) ASSERT_EQ(host.view().data()[byte], std::byte{0});
  }
}

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

TEST_F(CudaArray, gathers_from_and_scatters_to_scattered_host_objects) {
  std::vector<elasticity::NodePosition<float>> objects(1003);
  std::vector<elasticity::NodePosition<float>*> pointers;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    objects[i].x = Eigen::Vector3f(static_cast<float>(i), 1, 2);
    pointers.push_back(&objects[objects.size() - 1 - i]);
  }
  const std::span<elasticity::NodePosition<float>* const> all(pointers);
  Array<elasticity::NodePositionObject, float, Cuda, Soa> array;
  gather(array, all, [](const auto& object) { return object; });
  EXPECT_EQ(array.getdata(0, 0), 1002);
  array.putdata(5, 1, -7);
  scatter(all, array, [](auto& object, const auto& value) { object = value; });
  EXPECT_EQ(objects[997].x, Eigen::Vector3f(997, -7, 2));
  EXPECT_EQ(objects[996].x, Eigen::Vector3f(996, 1, 2));
}

}  // namespace
}  // namespace physgen::test
