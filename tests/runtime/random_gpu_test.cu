// Random numbers on a CUDA device are those of the host.
#include <physgen/cuda/parallel_for.h>

#include "gpu_fixture.h"
#include "random_checks.h"

namespace physgen::test {
namespace {

class CudaRandomNumbers : public GpuTest {};

struct DrawOnDevice {
  template <class Kernel>
  void operator()(index_t begin, index_t end, const Kernel& kernel) const {
    parallel_for(Cuda{}, begin, end, kernel);
  }
};

TEST_F(CudaRandomNumbers, are_those_of_the_host) {
  check_random_numbers<float, Cuda>(DrawOnDevice{});
  check_random_numbers<double, Cuda>(DrawOnDevice{});
}

}  // namespace
}  // namespace physgen::test
