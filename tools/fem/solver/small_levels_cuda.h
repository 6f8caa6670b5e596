// The small levels of a V-cycle in one kernel on CUDA. What a launch takes, about a microsecond, is less than a barrier
// of several thread blocks and their loads from memory that another one has written; within one thread block both are
// short, so that one runs the program of cycle.h over the levels' views while its sums are few. And sums of rows by
// lanes of a warp. For CUDA translation units.
#pragma once

#include <fem/kernels/edge_slices_cuda.h>
#include <fem/solver/cycle.h>
#include <fem/solver/level_views.h>
#include <fem/solver/performs_in.h>
#include <physgen/cuda/executor.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace physgen::fem {

namespace detail {

/// A row of a kernel that sums rows (row_sums.h), by neighbouring lanes of a warp, all 32 of which come here.
/// @param thread kernel.lanes of them have the row thread / kernel.lanes
template <class Kernel>
__device__ void sum_row(index_t thread, index_t rows, const Kernel& kernel) {
  using Sum = decltype(kernel.part(index_t{0}, Lane{}));
  constexpr int lanes = Kernel::lanes;
  const index_t row = thread / lanes;
  const Lane lane{static_cast<int>(thread % lanes), lanes};
  Sum sum = Sum::Zero();
  if (row < rows) sum = kernel.part(row, lane);
  PHYSGEN_UNROLL
  for (int distance = lanes / 2; distance > 0; distance /= 2) {
    PHYSGEN_UNROLL
    for (int k = 0; k < 3; ++k) sum[k] += __shfl_down_sync(~0U, sum[k], distance, lanes);
  }
  if (row < rows && lane.number == 0) kernel.put(row, sum);
}

template <class Kernel>
__global__ void sum_rows(index_t rows, const Kernel kernel) {
  sum_row(blockIdx.x * index_t{blockDim.x} + threadIdx.x, rows, kernel);
}

}  // namespace detail

/// See row_sums.h.
template <PerformsIn<Cuda> On, class Kernel>
void run_rows(On& on, index_t rows, const Kernel& kernel) {
  if (rows == 0) return;
  constexpr int threads = 256;
  const auto blocks = static_cast<unsigned>((rows * Kernel::lanes + threads - 1) / threads);
  on.perform([&](Stream stream) {
    detail::sum_rows<<<blocks, threads, 0, stream>>>(rows, kernel);
    cuda::check(cudaGetLastError(), "launching sums of rows");
  });
}

/// Runs the steps of a program by the threads of one thread block, each of which makes one.
class BlockExecutor {
 public:
  template <class Kernel>
  __device__ void run(index_t n, const Kernel& kernel) const {
    for (index_t i = threadIdx.x; i < n; i += blockDim.x) kernel(i);
    __syncthreads();
  }
};

/// See row_sums.h.
template <class Kernel>
__device__ void run_rows(const BlockExecutor& /*on*/, index_t rows, const Kernel& kernel) {
  const index_t lanes = rows * Kernel::lanes;
  for (index_t warp = threadIdx.x / 32 * 32; warp < lanes; warp += blockDim.x) {
    detail::sum_row(warp + threadIdx.x % 32, rows, kernel);
  }
  __syncthreads();
}

/// r += the edges' part of K d.
template <class Level>
__device__ void add_scaled_edges(const BlockExecutor& /*on*/, const Level& level) {
  const SliceProduct product{level.slices, level.scaled_edges.const_view(), level.direction.const_view(),
                             level.residual.view()};
  detail::add_slices(product);
  __syncthreads();
}

namespace detail {

/// Levels of at most so many nodes are small. PHYSGEN_SMALL_LEVELS in the environment is a smaller number; of 0, every
/// step is a launch, for comparisons.
[[nodiscard]] inline index_t most_small_nodes() {
  const char* given = std::getenv("PHYSGEN_SMALL_LEVELS");
  return given == nullptr ? index_t{EdgeSlices::most_nodes}
                          : std::min(index_t{std::atol(given)}, index_t{EdgeSlices::most_nodes});
}
constexpr std::size_t most_small_levels = 8;
/// As many as have registers enough for what they do.
template <class Real>
constexpr int small_level_threads = sizeof(Real) == 8 ? 512 : 768;

/// The arguments of run_small_levels(); levels as v_cycle() takes them.
template <class Views>
struct SmallLevels {
  std::array<Views, most_small_levels> levels;  ///< behind `count` the last one again
  std::size_t count;
  PreconditionerSettings settings;

  [[nodiscard]] __device__ std::size_t size() const { return count; }
  [[nodiscard]] __device__ const Views* operator[](std::size_t l) const { return &levels[l]; }
};

template <class Real, class Views>
__global__ void __launch_bounds__(small_level_threads<Real>)
    run_small_levels(const __grid_constant__ SmallLevels<Views> levels) {
  const BlockExecutor on;
  v_cycle(on, levels, 0, levels.settings);
}

template <class Levels, std::size_t... kNumbers>
[[nodiscard]] auto level_views(Levels& levels, std::size_t first, std::index_sequence<kNumbers...> /*numbers*/) {
  using Level = std::remove_reference_t<decltype(*levels[0])>;
  return std::array{LevelViews<Level>(*levels[std::min(first + kNumbers, levels.size() - 1)])...};
}

}  // namespace detail

/// See cycle.h.
template <PerformsIn<Cuda> On, class Levels>
bool cycle_at_once(On& on, Levels& levels, std::size_t l, const PreconditionerSettings& settings) {
  using Level = std::remove_reference_t<decltype(*levels[0])>;
  using Real = typename Level::Real;
  const std::size_t count = levels.size() - l;
  if (levels[l]->nodes() > detail::most_small_nodes() || levels[l]->slices.is_empty()) return false;
  if (count > detail::most_small_levels) return false;
  const detail::SmallLevels<LevelViews<Level>> small{
      detail::level_views(levels, l, std::make_index_sequence<detail::most_small_levels>()), count, settings};
  on.perform([&](Stream stream) {
    detail::run_small_levels<Real><<<1, detail::small_level_threads<Real>, 0, stream>>>(small);
    cuda::check(cudaGetLastError(), "launching the small levels of a cycle");
  });
  return true;
}

}  // namespace physgen::fem
