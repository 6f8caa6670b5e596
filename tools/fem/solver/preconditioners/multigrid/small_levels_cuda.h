// The small levels of a V-cycle in one kernel on CUDA: the program of cycle.h over the levels' views, by the threads of
// a cluster of thread blocks. Between two steps these meet at a barrier of the hardware, which takes a fraction of what
// a launch does. For CUDA translation units.
#pragma once

#include <fem/solver/performs_in.h>
#include <fem/solver/preconditioners/multigrid/cycle.h>
#include <fem/solver/preconditioners/multigrid/level_views.h>
#include <fem/solver/preconditioners/multigrid/row_product.h>
#include <fem/solver/row_sums_cuda.h>
#include <physgen/cuda/executor.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace physgen::fem {

/// Runs the steps of a program by the threads of a cluster, or of one thread block, that are all there are: each block
/// takes a range of the objects.
class ClusterExecutor {
 public:
  template <class Kernel>
  __device__ void run(index_t n, const Kernel& kernel) const {
    const index_t begin = first(n, blockIdx.x), end = first(n, blockIdx.x + 1);
    for (index_t i = begin + threadIdx.x; i < end; i += blockDim.x) kernel(i);
    meet();
  }
  /// Rows of a kernel that sums them.
  template <class Kernel>
  __device__ void run_rows(index_t rows, const Kernel& kernel) const {
    const index_t begin = first(rows, blockIdx.x), end = first(rows, blockIdx.x + 1);
    const index_t lanes = (end - begin) * Kernel::lanes;
    for (index_t warp = threadIdx.x / 32 * 32; warp < lanes; warp += blockDim.x) {
      detail::sum_row(warp + threadIdx.x % 32, begin, end, kernel);
    }
    meet();
  }

 private:
  __device__ static index_t first(index_t n, unsigned block) { return n * block / gridDim.x; }
  /// Values that threads have written before it are seen by all behind it.
  __device__ static void meet() {
#if __CUDA_ARCH__ >= 900
    asm volatile("barrier.cluster.arrive.release.aligned;\n\tbarrier.cluster.wait.acquire.aligned;" ::: "memory");
#else
    __syncthreads();
#endif
  }
};

/// See row_sums.h.
template <class Kernel>
__device__ void run_rows(const ClusterExecutor& on, index_t rows, const Kernel& kernel) {
  on.run_rows(rows, kernel);
}

/// r += the edges' part of K d.
template <class Level>
__device__ void add_scaled_edges(const ClusterExecutor& on, const Level& level) {
  on.run_rows(level.nodes(), AddRowProduct{level.rows, level.scaled_edges.const_view(), level.direction.const_view(),
                                           level.residual.view()});
}

namespace detail {

/// Levels of at most so many nodes are small. PHYSGEN_SMALL_LEVELS in the environment is a smaller number; of 0, every
/// step is a launch, for comparisons.
[[nodiscard]] inline index_t most_small_nodes() {
  const char* given = std::getenv("PHYSGEN_SMALL_LEVELS");
  return given == nullptr ? index_t{EdgeRows::most_nodes}
                          : std::min(index_t{std::atol(given)}, index_t{EdgeRows::most_nodes});
}
constexpr std::size_t most_small_levels = 8;
constexpr unsigned most_cluster_blocks = 16;  ///< all devices that have clusters allow 8
constexpr int small_level_threads = 512;      ///< as many as have registers enough for what they do

/// The arguments of run_small_levels(); levels as v_cycle() takes them.
template <class Views>
struct SmallLevels {
  std::array<Views, most_small_levels> levels;  ///< behind `count` the last one again
  std::size_t count;
  PreconditionerSettings settings;

  [[nodiscard]] __device__ std::size_t size() const { return count; }
  [[nodiscard]] __device__ const Views* operator[](std::size_t l) const { return &levels[l]; }
};

template <class Views>
__global__ void __launch_bounds__(small_level_threads)
    run_small_levels(const __grid_constant__ SmallLevels<Views> levels) {
  const ClusterExecutor on;
  v_cycle(on, levels, 0, levels.settings);
}

/// Launches of a kernel by one cluster of thread blocks.
struct ClusterLaunch {
  cudaLaunchAttribute cluster{};
  cudaLaunchConfig_t config{};

  ClusterLaunch(unsigned blocks, Stream stream) {
    cluster.id = cudaLaunchAttributeClusterDimension;
    cluster.val.clusterDim = {blocks, 1, 1};
    config.gridDim = blocks;
    config.blockDim = small_level_threads;
    config.stream = stream;
    config.attrs = &cluster;
    config.numAttrs = 1;
  }
  ClusterLaunch(const ClusterLaunch&) = delete;
  ClusterLaunch& operator=(const ClusterLaunch&) = delete;
};

/// The thread blocks of a kernel's largest cluster: one where the device or the compiled kernel has no clusters.
template <class Global>
[[nodiscard]] unsigned blocks_of_cluster(Global* kernel) {
  int device = 0, has_clusters = 0;
  cudaFuncAttributes attributes{};
  cuda::check(cudaGetDevice(&device), "asking for the current device");
  cuda::check(cudaDeviceGetAttribute(&has_clusters, cudaDevAttrClusterLaunch, device),
              "asking whether it has clusters");
  cuda::check(cudaFuncGetAttributes(&attributes, kernel), "asking what a kernel was compiled for");
  if (has_clusters == 0 || attributes.ptxVersion < 90) return 1;
  cuda::check(cudaFuncSetAttribute(kernel, cudaFuncAttributeNonPortableClusterSizeAllowed, 1),
              "allowing clusters of any size");
  for (unsigned blocks = most_cluster_blocks; blocks > 1; blocks /= 2) {
    int clusters = 0;
    const ClusterLaunch launch(blocks, nullptr);
    const cudaError_t answer = cudaOccupancyMaxActiveClusters(&clusters, kernel, &launch.config);
    if (answer == cudaErrorInvalidClusterSize) {  // so devices refuse sizes that none of their kernels has
      static_cast<void>(cudaGetLastError());
      continue;
    }
    cuda::check(answer, "asking for the size of clusters");
    if (clusters > 0) return blocks;
  }
  return 1;
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
  const std::size_t count = levels.size() - l;
  if (count > detail::most_small_levels || !are_small(levels, l, detail::most_small_nodes())) return false;
  using Small = detail::SmallLevels<LevelViews<Level>>;
  const Small small{detail::level_views(levels, l, std::make_index_sequence<detail::most_small_levels>()), count,
                    settings};
  static thread_local int asked_device = -1;
  static thread_local unsigned blocks = 1;
  int device = 0;
  cuda::check(cudaGetDevice(&device), "asking for the current device");
  if (device != asked_device) blocks = detail::blocks_of_cluster(detail::run_small_levels<LevelViews<Level>>);
  asked_device = device;
  const auto launch = [&](Stream stream) {
    if (blocks == 1) {
      detail::run_small_levels<LevelViews<Level>><<<1, detail::small_level_threads, 0, stream>>>(small);
      cuda::check(cudaGetLastError(), "launching the small levels of a cycle");
    } else {
      const detail::ClusterLaunch launch(blocks, stream);
      cuda::check(cudaLaunchKernelEx(&launch.config, detail::run_small_levels<LevelViews<Level>>, small),
                  "launching the small levels of a cycle");
    }
  };
  Level& top = *levels[l];
  detail::perform_here(on, launch, scaled_product(top, top.residual.const_view(), top.correction.view()));
  return true;
}

}  // namespace physgen::fem
