// How an executor of several ranks is made.
#pragma once

#include <physgen/config.h>

namespace physgen {

/// Of DistributedExecutor.
struct DistributedOptions {
  /// Fields of ghosts become signalling NaN when they turn stale: a step that reads them nevertheless is seen.
  bool poisons_stale_ghosts = checked_build;
  // Of executors on CUDA.
  index_t result_bytes = 64;  ///< of the largest result of a reduction
  bool uses_nccl = true;      ///< else fields cross through pinned memory and MPI
};

/// @tparam On which runs the steps of each rank: HostExecutor, or CudaExecutor (distributed/cuda/executor.h)
template <class On>
class DistributedExecutor;

}  // namespace physgen
