// Fused kernels on a CUDA device: see fuse_checks.h.
#include <physgen/cuda/executor.h>

#include "fuse_checks.h"
#include "gpu_fixture.h"

namespace physgen::test {
namespace {

class CudaFuse : public GpuTest {};

struct OnDevice {
  template <class Kernel>
  void operator()(index_t begin, index_t end, const Kernel& kernel) const {
    parallel_for(Cuda{}, begin, end, kernel);
  }
};

TEST_F(CudaFuse, has_the_bits_of_separate_kernels) {
  check_fused<float, Cuda, Soa>(OnDevice{});
  check_fused<double, Cuda, Aosoa<32>>(OnDevice{});
  check_fused<float, Cuda, AosPadded>(OnDevice{});
}

TEST_F(CudaFuse, runs_on_executors_and_folds_what_the_last_step_returns) {
  CudaExecutor on(1000);
  check_fused_on<Cuda>(on);
}

}  // namespace
}  // namespace physgen::test
