// The uses that nvcc's compiler of the host finds in the same kernels, as programs on CUDA have them. No device is
// needed, and no kernel runs, so that there is nothing here for nvcc's compiler of the device.
#ifndef __CUDA_ARCH__
#include "probe_kernels.h"

namespace physgen::fem::test {

struct only_on_the_device {
  [[maybe_unused]] static constexpr const char* name = "only_on_the_device";
};

namespace {

TEST(ProbesOfKernels, find_what_the_kernels_say_on_cuda) {
  ProbeExecutor<Cuda> on;
  run_all_kernels(on);
  EXPECT_EQ(what_is_found(), what_kernels_do());
}

template <class View>
struct DeviceFunction {
  View view;
  __device__ void operator()(index_t i) const { view[i].volume() = __shfl_sync(0xffffffffU, 1.0F, 0); }
};

// The host's compiler finds uses of the arrays above: their kernels are functions of host and device.
TEST(ProbesOfKernels, say_of_which_arrays_the_host_sees_nothing) {
  ProbeOf<elasticity::RestShapeArray<float, Cuda>, only_on_the_device> shapes;
  ProbeExecutor<Cuda> on;
  on.run(1, DeviceFunction<decltype(shapes)::View>{shapes.view()});
  EXPECT_EQ(probe::unseen(), std::vector<std::string>{"only_on_the_device"});
}

}  // namespace
}  // namespace physgen::fem::test
#endif
