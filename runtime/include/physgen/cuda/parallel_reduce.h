// Runs a kernel over objects on a CUDA device and folds what it returns into one value: see reduce.h for folds and the
// order. Included by CUDA translation units only.
#pragma once

#include <physgen/cuda/parallel_for.h>
#include <physgen/detail/cuda_reduction.h>
#include <physgen/detail/host_loop.h>
#include <physgen/launch/reduce.h>
#include <physgen/launch/reduce_workspace.h>

#include <algorithm>

namespace physgen {

/// Calls kernel(i) for the objects begin .. end-1 on the current device, ordered in `stream`, folds what the calls
/// return, and calls then(value) on the device, once. Does not wait and allocates nothing; can be captured in a graph.
/// The kernel may also store fields, which `then` sees.
/// @tparam Fold Sum, Max, Min, Argmax, All, Any, Count, or one's own; see reduce.h
/// @param then takes the fold's Value, or of several terms a std::array or Eigen matrix of them
/// @pre no other reduction in the workspace is under way, but for those before this one in `stream`
/// @throw Error when the workspace is too small or the launch fails
template <class Kernel, class Fold, class Then>
  requires(!std::is_integral_v<Kernel> && !std::is_same_v<Then, ReduceWorkspace>)
void parallel_reduce(Cuda /*space*/, index_t begin, index_t end, const Kernel& kernel, Fold /*fold*/, const Then& then,
                     ReduceWorkspace& workspace, Stream stream = nullptr) {
  detail::check_range_of_launch(begin);
  workspace.require(std::max(end - begin, index_t{0}), cuda::value_bytes<Kernel, Fold>);
  const index_t count = detail::blocks_of(begin, end);
  cuda::launch_reduction<Fold>({begin, end, count, 0, count, true, 0}, kernel, then, workspace, stream);
}

/// The same part by part: kernel(i) for the objects 0 .. part.count-1, and then(value of all parts) behind the last.
/// The workspace holds the values of blocks from one part to the next.
/// @pre no other reduction in the workspace stands between two parts
/// @throw Error when the part does not begin and end with whole blocks, the workspace is too small for all parts, or
/// the launch fails
template <class Kernel, class Fold, class Then>
void parallel_reduce_part(Cuda /*space*/, const PartOfReduction& part, const Kernel& kernel, Fold /*fold*/,
                          const Then& then, ReduceWorkspace& workspace, Stream stream = nullptr) {
  part.check();
  workspace.require(part.of, cuda::value_bytes<Kernel, Fold>);
  const index_t count = detail::blocks_of(0, part.count);
  cuda::launch_reduction<Fold>({0, part.count, count, part.first_block(), part.blocks(), part.is_last(), part.first},
                               kernel, then, workspace, stream);
}

/// A reduction on a device allocates nothing, so it is handed its memory.
template <class Kernel, class Fold>
  requires(!std::is_integral_v<Kernel>)
cuda::a_reduction_on_a_device_needs_a_ReduceWorkspace_as_its_last_argument parallel_reduce(Cuda space, index_t begin,
                                                                                           index_t end,
                                                                                           const Kernel& kernel,
                                                                                           Fold fold) = delete;
template <class Kernel, class Fold>
  requires(!std::is_integral_v<Kernel>)
cuda::a_reduction_on_a_device_needs_a_ReduceWorkspace_as_its_last_argument parallel_reduce(Cuda space, index_t size,
                                                                                           const Kernel& kernel,
                                                                                           Fold fold) = delete;

/// The same, but waits for the value and returns it.
/// @throw Error also when `stream` is being captured, as nothing can be waited for there: hand over `then`
template <class Kernel, class Fold>
  requires(!std::is_integral_v<Kernel>)
auto parallel_reduce(Cuda space, index_t begin, index_t end, const Kernel& kernel, Fold fold,
                     ReduceWorkspace& workspace, Stream stream = nullptr) {
  using Result = typename detail::Reduction<Kernel, Fold, index_t>::Result;
  cudaStreamCaptureStatus capture = cudaStreamCaptureStatusNone;
  cuda::check(cudaStreamIsCapturing(stream, &capture), "asking whether a stream is captured");
  if (capture != cudaStreamCaptureStatusNone) {
    throw Error(
        "parallel_reduce() that returns its value was called in a stream that is being captured, where nothing "
        "can be waited for; hand it a function that takes the value on the device");
  }
  auto* const result = reinterpret_cast<Result*>(workspace.result());
  parallel_reduce(space, begin, end, kernel, fold, cuda::StoreResult<Result>{result}, workspace, stream);
  cuda::check(cudaStreamSynchronize(stream), "waiting for a reduction");
  return *result;
}

/// Both for the objects 0 .. size-1.
template <class Kernel, class Fold, class... Rest>
  requires(!std::is_integral_v<Kernel>)
auto parallel_reduce(Cuda space, index_t size, const Kernel& kernel, Fold fold, Rest&&... rest) {
  return parallel_reduce(space, index_t{0}, size, kernel, fold, std::forward<Rest>(rest)...);
}

}  // namespace physgen
