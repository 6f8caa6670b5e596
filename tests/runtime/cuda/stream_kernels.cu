// See stream_kernels.h. Without physgen's launches, whose headers nvcc reads longer than all else here.
#include <physgen/cuda/check.h>

#include "stream_kernels.h"

namespace physgen::test {

namespace {

__global__ void spin_for(long long cycles) {
  const long long start = clock64();
  while (clock64() - start < cycles) {
  }
}

__global__ void trap_at_once() { __trap(); }

}  // namespace

void spin(Stream stream) {
  spin_for<<<1, 1, 0, stream>>>(100000000);
  cuda::check(cudaGetLastError(), "starting a kernel that spins");
}
void trap(Stream stream) {
  trap_at_once<<<1, 1, 0, stream>>>();
  cuda::check(cudaGetLastError(), "starting a kernel that traps");
}

}  // namespace physgen::test
