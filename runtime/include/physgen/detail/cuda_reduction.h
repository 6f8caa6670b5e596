// Reductions on a CUDA device, in the order of reduce.h: thread blocks reduce blocks of objects, and the last of them
// joins what they have. Included by CUDA translation units only.
#pragma once

#include <physgen/cuda/check.h>
#include <physgen/detail/check_numbers.h>
#include <physgen/detail/reduction.h>
#include <physgen/launch/reduce_workspace.h>

#include <algorithm>
#include <cstring>

namespace physgen::cuda {

inline constexpr int reduce_threads = 256;
inline constexpr int reduce_warps = reduce_threads / detail::reduce_lanes;

/// The number of terms that a thread forms before they are joined: enough loads are then on their way, and the kernel's
/// code is repeated as often. For dot products of two fields of vectors, 1, 4 and 8 are slower on an H200, and so are
/// 128 and 512 threads.
template <class Types>
constexpr int terms_at_once() {
  constexpr auto bytes = static_cast<int>(sizeof(typename Types::Number)) * Types::count;
  static_assert(2 * bytes * reduce_threads + reduce_threads * int{sizeof(typename Types::Value)} + 64 <= 48 * 1024,
                "the term of a reduction on a device has about 88 bytes at most: fold parts of it one by one");
  return bytes <= 16 ? 2 : 1;
}

/// The value of the lane `step` further on in the warp.
template <class Value>
__device__ Value from_lane(const Value& value, int step) {
  constexpr int words = (int{sizeof(Value)} + 3) / 4;
  unsigned bits[words] = {};
  memcpy(bits, &value, sizeof(Value));
  PHYSGEN_UNROLL
  for (int w = 0; w < words; ++w) bits[w] = __shfl_down_sync(~0U, bits[w], step);
  Value other;
  memcpy(&other, bits, sizeof(Value));
  return other;
}

/// The range, the number of its blocks, and where their values lie among those of all blocks that are joined as one.
struct Blocks {
  index_t begin, end;
  index_t count;
  index_t first = 0;    ///< the number of the range's first block
  index_t all = count;  ///< blocks that are joined
  bool is_last = true;  ///< whether these are the last of them
  index_t shift = 0;    ///< folds know object i by the number i + shift
};

/// The values of this thread block's blocks of objects. All its threads form terms; of each block one warp joins them,
/// in order, while the others go on.
template <class Types, class Fold, class Kernel>
__device__ void reduce_blocks(const Blocks& blocks, const Kernel& kernel, typename Types::Value* values) {
  using Number = typename Types::Number;
  using Value = typename Types::Value;
  constexpr int at_once = terms_at_once<Types>();
  constexpr int chunk = reduce_threads * at_once;
  __shared__ Number terms[2][Types::count][chunk];
  const int thread = static_cast<int>(threadIdx.x), lane = thread % detail::reduce_lanes;
  const index_t first = blocks.begin / detail::reduce_block;
  int half = 0, turn = 0;
  for (index_t block = blockIdx.x; block < blocks.count; block += gridDim.x) {
    const index_t at = (first + block) * detail::reduce_block;
    const bool whole = blocks.begin <= at && at + detail::reduce_block <= blocks.end;
    const bool joins = thread / detail::reduce_lanes == turn;
    turn = (turn + 1) % reduce_warps;
    Value lanes[Types::count];
    PHYSGEN_UNROLL
    for (int k = 0; k < Types::count; ++k) lanes[k] = Fold::template identity<Number>();
#pragma unroll 1
    for (int from = 0; from < detail::reduce_block; from += chunk) {
      const auto keep = [&](const typename Types::Term& term, int place) {
        PHYSGEN_UNROLL
        for (int k = 0; k < Types::count; ++k) terms[half][k][place] = Types::Entries::entry(term, k);
      };
      const auto join = [&](index_t i) {
        PHYSGEN_UNROLL
        for (int k = 0; k < Types::count; ++k) {
          const Number term = terms[half][k][i - at - from];
          lanes[k] = Fold::join(lanes[k], Fold::template value<Number>(term, i + blocks.shift));
        }
      };
      if (whole) {
        typename Types::Term formed[at_once];
        PHYSGEN_UNROLL
        for (int t = 0; t < at_once; ++t) formed[t] = kernel(at + from + t * reduce_threads + thread);
        PHYSGEN_UNROLL
        for (int t = 0; t < at_once; ++t) keep(formed[t], t * reduce_threads + thread);
      } else {
#pragma unroll 1
        for (int t = 0; t < at_once; ++t) {
          const index_t i = at + from + t * reduce_threads + thread;
          if (blocks.begin <= i && i < blocks.end) keep(kernel(i), t * reduce_threads + thread);
        }
      }
      __syncthreads();
      if (joins && whole) {
#pragma unroll 8
        for (int s = 0; s < chunk; s += detail::reduce_lanes) join(at + from + s + lane);
      } else if (joins) {
#pragma unroll 1
        for (int s = 0; s < chunk; s += detail::reduce_lanes) {
          const index_t i = at + from + s + lane;
          if (blocks.begin <= i && i < blocks.end) join(i);
        }
      }
      half = 1 - half;
    }
    if (joins) {
      PHYSGEN_UNROLL
      for (int k = 0; k < Types::count; ++k) {
        PHYSGEN_UNROLL
        for (int step = detail::reduce_lanes / 2; step > 0; step /= 2) {
          lanes[k] = Fold::join(lanes[k], from_lane(lanes[k], step));
        }
        if (lane == 0) values[k * blocks.all + blocks.first + block] = lanes[k];
      }
    }
  }
}

/// The value of all blocks, from those of each; by one thread block, for its thread 0.
template <class Number, class Fold, class Value>
__device__ Value join_blocks(const Value* values, index_t count) {
  constexpr int per_thread = detail::reduce_strands / reduce_threads;
  __shared__ Value shared[reduce_threads];
  const int thread = static_cast<int>(threadIdx.x);
  Value strands[per_thread];
  PHYSGEN_UNROLL
  for (int j = 0; j < per_thread; ++j) strands[j] = Fold::template identity<Number>();
#pragma unroll 2
  for (index_t from = 0; from < count; from += detail::reduce_strands) {
    Value read[per_thread];
    PHYSGEN_UNROLL
    for (int j = 0; j < per_thread; ++j) {
      const index_t b = from + j * reduce_threads + thread;
      read[j] = values[b < count ? b : 0];
    }
    PHYSGEN_UNROLL
    for (int j = 0; j < per_thread; ++j) {
      if (from + j * reduce_threads + thread < count) strands[j] = Fold::join(strands[j], read[j]);
    }
  }
  PHYSGEN_UNROLL
  for (int step = per_thread / 2; step > 0; step /= 2) {
    PHYSGEN_UNROLL
    for (int j = 0; j < step; ++j) {
      if ((j + step) * reduce_threads + thread < count) strands[j] = Fold::join(strands[j], strands[j + step]);
    }
  }
  __syncthreads();  // those that read the last entry's are done
  shared[thread] = strands[0];
  __syncthreads();
  if (thread >= detail::reduce_lanes) return strands[0];
  Value sums[reduce_warps];
  PHYSGEN_UNROLL
  for (int j = 0; j < reduce_warps; ++j) sums[j] = shared[j * detail::reduce_lanes + thread];
  PHYSGEN_UNROLL
  for (int step = reduce_warps / 2; step > 0; step /= 2) {
    PHYSGEN_UNROLL
    for (int j = 0; j < step; ++j) {
      if ((j + step) * detail::reduce_lanes + thread < count) sums[j] = Fold::join(sums[j], sums[j + step]);
    }
  }
  Value value = sums[0];
  PHYSGEN_UNROLL
  for (int step = detail::reduce_lanes / 2; step > 0; step /= 2) {
    const Value other = from_lane(value, step);
    if (thread + step < count) value = Fold::join(value, other);
  }
  return value;
}

template <class Types, class Fold, class Kernel, class Then>
__global__ void __launch_bounds__(reduce_threads)
    reduce_objects(const Blocks blocks, const Kernel kernel, const Then then, typename Types::Value* values,
                   unsigned* finished) {
  reduce_blocks<Types, Fold>(blocks, kernel, values);
  // The thread block that is done last sees the values of all; atomicInc() leaves 0 for the next reduction.
  __shared__ bool last;
  __threadfence();
  __syncthreads();
  if (threadIdx.x == 0) last = atomicInc(finished, gridDim.x - 1) == gridDim.x - 1;
  __syncthreads();
  if (!last || !blocks.is_last) return;
  __threadfence();
  typename Types::Value result[Types::count];
  PHYSGEN_UNROLL
  for (int k = 0; k < Types::count; ++k) {
    result[k] = join_blocks<typename Types::Number, Fold>(values + k * blocks.all, blocks.all);
  }
  if (threadIdx.x == 0) then(Types::Entries::result(static_cast<const typename Types::Value*>(result)));
}

/// The number of thread blocks of a kernel that run at once on the current device.
template <class Global>
[[nodiscard]] index_t blocks_at_once(Global* kernel) {
  int device = 0, processors = 0, blocks = 0;
  check(cudaGetDevice(&device), "asking for the current device");
  check(cudaDeviceGetAttribute(&processors, cudaDevAttrMultiProcessorCount, device), "asking for its size");
  check(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&blocks, kernel, reduce_threads, 0), "asking what runs at once");
  return std::max(index_t{processors} * blocks, index_t{1});
}

/// Bytes of the value of one block.
template <class Kernel, class Fold>
inline constexpr index_t value_bytes = index_t{sizeof(typename detail::Reduction<Kernel, Fold, index_t>::Value)} *
                                       detail::Reduction<Kernel, Fold, index_t>::count;

/// @pre the workspace has room for the values of all blocks
template <class Fold, class Kernel, class Then>
void launch_reduction(const Blocks& blocks, const Kernel& kernel, const Then& then, ReduceWorkspace& workspace,
                      Stream stream) {
  using Types = detail::Reduction<Kernel, Fold, index_t>;
  detail::check_numbers(kernel);
  static const index_t at_once = blocks_at_once(reduce_objects<Types, Fold, Kernel, Then>);
  const auto grid = static_cast<unsigned>(std::clamp(blocks.count, index_t{1}, at_once));
  reduce_objects<Types, Fold><<<grid, reduce_threads, 0, stream>>>(
      blocks, kernel, then, reinterpret_cast<typename Types::Value*>(workspace.values()), workspace.finished());
  check(cudaGetLastError(), "launching a reduction");
}

struct a_reduction_on_a_device_needs_a_ReduceWorkspace_as_its_last_argument {};

/// For reductions that return their value.
template <class Result>
struct StoreResult {
  Result* to;
  PHYSGEN_FUNCTION void operator()(const Result& result) const { *to = result; }
};

}  // namespace physgen::cuda
