// See stream_kernels.h.
#include <physgen/cuda/parallel_for.h>

#include "stream_kernels.h"

namespace physgen::test {

namespace {

struct Spin {
  long long cycles;
  __device__ void operator()(index_t /*i*/) const {
    const long long start = clock64();
    while (clock64() - start < cycles) {
    }
  }
};

struct Trap {
  __device__ void operator()(index_t /*i*/) const { __trap(); }
};

}  // namespace

void spin(Stream stream) { parallel_for(Cuda{}, 1, Spin{100000000}, stream); }
void trap(Stream stream) { parallel_for(Cuda{}, 1, Trap{}, stream); }

}  // namespace physgen::test
