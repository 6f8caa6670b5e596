// Fused groups of kernels on a CUDA device: see fused_checks.h.
#include <physgen/cuda/parallel_for.h>

#include "fused_checks.h"

namespace physgen::fem {
namespace {

struct OnDevice {
  template <class Kernel>
  static void over(index_t begin, index_t end, const Kernel& kernel) {
    parallel_for(Cuda{}, begin, end, kernel);
  }
  template <class Kernel>
  static void one_by_one(index_t size, const Kernel& kernel) {
    parallel_for(Cuda{}, size, kernel);
  }
};

class FusedKernelsOnCuda : public testing::Test {
 protected:
  void SetUp() override {
    if (!cuda_available()) GTEST_SKIP() << "no CUDA device here";
  }
};

TEST_F(FusedKernelsOnCuda, have_the_bits_of_separate_ones) {
  check_materials<FusedCase<float, Cuda, Aosoa<32>, OnDevice>>();
  check_materials<FusedCase<double, Cuda, Soa, OnDevice>>();
}
TEST_F(FusedKernelsOnCuda, sum_at_nodes_what_gathers_sum) {
  check_sums<FusedCase<float, Cuda, Aosoa<32>, OnDevice>>();
  check_sums<FusedCase<double, Cuda, AosPadded, OnDevice>>();
}

}  // namespace
}  // namespace physgen::fem
