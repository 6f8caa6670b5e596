// Runs a kernel over objects on a CUDA device: one thread per object. Included by CUDA translation units only.
#pragma once

#include <physgen/cuda/check.h>
#include <physgen/detail/check_numbers.h>
#include <physgen/detail/host_loop.h>
#include <physgen/kernels/add.h>
#include <physgen/kernels/lanes.h>
#include <physgen/memory/space.h>

namespace physgen {

namespace cuda {

template <class Kernel>
__global__ void for_each_object(index_t begin, index_t end, const Kernel kernel) {
  const index_t i = begin + blockIdx.x * index_t{blockDim.x} + threadIdx.x;
  if (i < end) kernel(i);
}

}  // namespace cuda

/// Calls kernel(i) for the objects begin .. end-1 on the current device, ordered in `stream`; does not wait.
/// @pre the kernel's views lie in memory the device can reach; no two calls write the same object, unless by add()
/// @throw Error when the launch fails
template <class Kernel>
void parallel_for(Cuda /*space*/, index_t begin, index_t end, const Kernel& kernel, Stream stream = nullptr) {
  detail::check_numbers(kernel);
  detail::check_range_of_launch(begin);
  if (begin >= end) return;
  constexpr int block = 256;
  const auto grid = static_cast<unsigned>((end - begin + block - 1) / block);
  cuda::for_each_object<<<grid, block, 0, stream>>>(begin, end, kernel);
  cuda::check(cudaGetLastError(), "launching a kernel");
}

/// The same for the objects 0 .. size-1.
template <class Kernel>
void parallel_for(Cuda space, index_t size, const Kernel& kernel, Stream stream = nullptr) {
  parallel_for(space, 0, size, kernel, stream);
}

}  // namespace physgen
