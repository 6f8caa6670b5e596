// Kernels that sum rows (row_sums.h), on CUDA: a row is given to neighbouring lanes of a warp. For CUDA translation
// units.
#pragma once

#include <fem/solver/performs_in.h>
#include <fem/solver/row_sums.h>
#include <physgen/cuda/check.h>
#include <physgen/kernel.h>

namespace physgen::fem {

namespace detail {

/// A row of a kernel that sums rows (row_sums.h), by neighbouring lanes of a warp, all 32 of which come here.
/// @param thread kernel.lanes of them have the row begin + thread / kernel.lanes, if that is below `end`
template <class Kernel>
__device__ void sum_row(index_t thread, index_t begin, index_t end, const Kernel& kernel) {
  using Sum = decltype(kernel.part(index_t{0}, Lane{}));
  constexpr int lanes = Kernel::lanes;
  const index_t row = begin + thread / lanes;
  const Lane lane{static_cast<int>(thread % lanes), lanes};
  Sum sum = Sum::Zero();
  if (row < end) sum = kernel.part(row, lane);
  PHYSGEN_UNROLL
  for (int distance = lanes / 2; distance > 0; distance /= 2) {
    PHYSGEN_UNROLL
    for (int k = 0; k < 3; ++k) sum[k] += __shfl_down_sync(~0U, sum[k], distance, lanes);
  }
  if (row < end && lane.number == 0) kernel.put(row, sum);
}

template <class Kernel>
__global__ void sum_rows(index_t begin, index_t end, const Kernel kernel) {
  sum_row(blockIdx.x * index_t{blockDim.x} + threadIdx.x, begin, end, kernel);
}

/// Starts the kernel for the rows begin .. end-1 in `stream`.
template <class Kernel>
void start_rows(index_t begin, index_t end, const Kernel& kernel, Stream stream) {
  if (begin == end) return;
  constexpr int threads = 256;
  const auto blocks = static_cast<unsigned>(((end - begin) * Kernel::lanes + threads - 1) / threads);
  sum_rows<<<blocks, threads, 0, stream>>>(begin, end, kernel);
  cuda::check(cudaGetLastError(), "launching sums of rows");
}

}  // namespace detail

/// See row_sums.h.
template <PerformsIn<Cuda> On, class Kernel>
void run_rows(On& on, index_t rows, const Kernel& kernel) {
  const auto launch = [&](index_t begin, index_t end, Stream stream) {
    detail::start_rows(begin, end, kernel, stream);
  };
  if constexpr (requires { on.run(rows, kernel, launch); }) {
    on.run(rows, kernel, launch);
  } else {
    on.perform([&](Stream stream) { launch(0, rows, stream); });
  }
}

}  // namespace physgen::fem
