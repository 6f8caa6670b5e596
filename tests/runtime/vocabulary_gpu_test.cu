// The words of kernels on a CUDA device.
#include <physgen/cuda/parallel_for.h>

#include "function_checks.h"
#include "gpu_fixture.h"

namespace physgen::test {
namespace {

class CudaVocabulary : public GpuTest {};

struct OnDevice {
  template <class Kernel>
  void operator()(index_t begin, index_t end, const Kernel& kernel) const {
    parallel_for(Cuda{}, begin, end, kernel);
  }
};

TEST_F(CudaVocabulary, asks_single_objects) {
  check_lanes<float, Cuda, Soa>(OnDevice{});
  check_lanes<double, Cuda, Aosoa<32>>(OnDevice{});
}
TEST_F(CudaVocabulary, has_functions_of_single_numbers) {
  check_functions<float, Cuda, Soa>(OnDevice{});
  check_functions<double, Cuda, Soa>(OnDevice{});
}

}  // namespace
}  // namespace physgen::test
