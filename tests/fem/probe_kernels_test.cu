// What nvcc's compiler of the host finds of the same kernels, as programs on CUDA have them. No device is needed.
#include "probe_kernels.h"

namespace physgen::fem::test {
namespace {

TEST(ProbesOfKernels, find_what_the_kernels_say_on_cuda) {
  ProbeExecutor<Cuda> on;
  run_all_kernels(on);
  EXPECT_EQ(what_is_found(), what_kernels_do());
  EXPECT_EQ(probe::unseen().size(), 0U) << "these kernels are functions of host and device";
}

}  // namespace
}  // namespace physgen::fem::test
