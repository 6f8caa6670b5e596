// The values of a rank's blocks in a reduction on a device, and the value of all ranks' blocks: joined in the order of
// one process (launch/reduce.h). Included by CUDA translation units only.
#pragma once

#include <physgen/cuda/parallel_for.h>
#include <physgen/detail/cuda_reduction.h>
#include <physgen/distributed/arrays.h>

#include <algorithm>
#include <array>
#include <string>

namespace physgen {

namespace cuda {

/// Where the values of blocks lie that ranks gave: those of rank r at r * stride, entry by entry.
struct GatheredBlocks {
  static constexpr int most_ranks = 256;
  int ranks;
  index_t stride;                       ///< values of a rank
  std::int32_t begins[most_ranks + 1];  ///< blocks before those of a rank, and all
};

/// Puts the values in the order of one process, joins them, and calls then(value). By one thread block.
template <class Types, class Fold, class Then>
__global__ void __launch_bounds__(reduce_threads)
    join_gathered(const __grid_constant__ GatheredBlocks blocks, const typename Types::Value* gathered,
                  typename Types::Value* ordered, const Then then) {
  const index_t all = blocks.begins[blocks.ranks];
  for (int r = 0; r < blocks.ranks; ++r) {
    const index_t before = blocks.begins[r], mine = blocks.begins[r + 1] - before;
    for (index_t w = threadIdx.x; w < mine * Types::count; w += reduce_threads) {
      const index_t k = w / mine;
      ordered[k * all + before + w - k * mine] = gathered[r * blocks.stride + w];
    }
  }
  __syncthreads();
  typename Types::Value result[Types::count];
  PHYSGEN_UNROLL
  for (int k = 0; k < Types::count; ++k) {
    result[k] = join_blocks<typename Types::Number, Fold>(ordered + k * all, all);
  }
  if (threadIdx.x == 0) then(Types::Entries::result(static_cast<const typename Types::Value*>(result)));
}

/// A kernel of a reduction whose terms do not count.
template <class Kernel>
struct WithoutTerm {
  Kernel kernel;
  __device__ void operator()(index_t i) const { (void)kernel(i); }
};

/// Stands for what launch_reduction() calls behind the last block, where that is not here.
struct Nothing {
  template <class Value>
  __device__ void operator()(const Value& /*value*/) const {}
};

}  // namespace cuda

namespace detail {

/// Of one reduction after another, in one stream. All kernels are called in it.
class DeviceBlockValues {
 public:
  /// @param result_bytes of the largest result. @pre cut() was called
  /// @throw Error when there are more ranks than its kernels know
  DeviceBlockValues(const DistributedArrays& arrays, index_t result_bytes)
      : workspace_(std::max(most_objects(arrays), most_blocks(arrays) * reduce_block), result_bytes),
        result_bytes_(result_bytes) {
    const int ranks = arrays.ranks().count();
    if (ranks > cuda::GatheredBlocks::most_ranks) {
      throw Error("reductions on CUDA know " + std::to_string(cuda::GatheredBlocks::most_ranks) +
                  " ranks, and there are " + std::to_string(ranks) + "; start as many at most");
    }
    index_t all = 0;
    for (const DistributedSet& set : arrays.sets()) {
      if (set.kind == DistributedSet::Kind::owned) all = std::max(all, blocks_of(0, set.local->runs().size()));
    }
    gathered_ = Buffer(SpaceKind::cuda, ranks * most_blocks(arrays) * result_bytes, "the values of all ranks' blocks");
    ordered_ = Buffer(SpaceKind::cuda, all * result_bytes, "the values of all ranks' blocks");
  }

  /// Objects of the longest reduction on this rank.
  [[nodiscard]] static index_t most_objects(const DistributedArrays& arrays) {
    index_t most = 1;
    for (const DistributedArray& array : arrays.arrays()) most = std::max(most, array.memory.size);
    for (const DistributedSet& set : arrays.sets()) {
      if (set.local) most = std::max(most, set.local->size());
    }
    return most;
  }

  /// Begins a reduction over the objects that a rank owns.
  /// @param set outlives the reduction
  /// @throw Error when the results are larger than was said
  template <class Fold, class Kernel>
  void begin(const LocalSet& set) {
    set_ = &set;
    if (cuda::value_bytes<Kernel, Fold> > result_bytes_) {
      throw Error("a reduction has a result of " + std::to_string(cuda::value_bytes<Kernel, Fold>) +
                  " bytes, and the executor was made for " + std::to_string(result_bytes_) +
                  "; give DistributedOptions this number of result_bytes");
    }
  }
  /// Calls the kernel for the local objects begin .. end-1 of those that are owned: whole blocks, or up to the last.
  /// @param shift the kernel is called with an object's number less this, which is a multiple of a block
  template <class Fold, class Kernel>
  void add(index_t begin, index_t end, index_t shift, const Kernel& kernel, Stream stream) {
    const cuda::Blocks blocks{begin - shift,
                              end - shift,
                              blocks_of(begin - shift, end - shift),
                              (begin - set_->begin()) / reduce_block,
                              mine(),
                              false,
                              shift + set_->runs().begin(set_->rank()) - set_->begin()};
    cuda::launch_reduction<Fold>(blocks, kernel, cuda::Nothing{}, workspace_, stream);
  }
  /// Calls the kernel for objects whose terms do not count.
  template <class Kernel>
  static void drop(index_t begin, index_t end, index_t shift, const Kernel& kernel, Stream stream) {
    if (begin < end) parallel_for(Cuda{}, begin - shift, end - shift, cuda::WithoutTerm<Kernel>{kernel}, stream);
  }

  /// Calls then(value) with the value of all ranks' objects, on every rank.
  template <class Fold, class Kernel, class Then>
  void join(Transport& transport, const Then& then, Stream stream) {
    using Types = Reduction<Kernel, Fold, index_t>;
    using Value = typename Types::Value;
    const Runs& runs = set_->runs();
    cuda::GatheredBlocks blocks{runs.ranks(), most_blocks(runs) * Types::count, {}};
    for (int r = 0; r < runs.ranks(); ++r) {
      blocks.begins[r + 1] = blocks.begins[r] + static_cast<std::int32_t>(blocks_of(runs.begin(r), runs.end(r)));
    }
    const index_t bytes = blocks.stride * index_t{sizeof(Value)};
    const std::vector<index_t> sizes(static_cast<std::size_t>(runs.ranks()), bytes);
    const auto count = static_cast<std::size_t>(bytes);
    if (bytes > 0) {
      transport.gather({workspace_.values(), count}, sizes,
                       {gathered_.data(), count * static_cast<std::size_t>(runs.ranks())});
    }
    cuda::join_gathered<Types, Fold><<<1, cuda::reduce_threads, 0, stream>>>(
        blocks, reinterpret_cast<const Value*>(gathered_.data()), reinterpret_cast<Value*>(ordered_.data()), then);
    cuda::check(cudaGetLastError(), "joining the values of all ranks' blocks");
  }

 private:
  [[nodiscard]] static index_t blocks_of_rank(const Runs& runs, int rank) {
    return blocks_of(runs.begin(rank), runs.end(rank));
  }
  [[nodiscard]] static index_t most_blocks(const Runs& runs) {
    index_t most = 0;
    for (int r = 0; r < runs.ranks(); ++r) most = std::max(most, blocks_of_rank(runs, r));
    return most;
  }
  /// Of any rank and set: each gives as many, so that this one's memory must have as many, too.
  [[nodiscard]] static index_t most_blocks(const DistributedArrays& arrays) {
    index_t most = 0;
    for (const DistributedSet& set : arrays.sets()) {
      if (set.kind == DistributedSet::Kind::owned) most = std::max(most, most_blocks(set.local->runs()));
    }
    return most;
  }
  [[nodiscard]] index_t mine() const { return blocks_of_rank(set_->runs(), set_->rank()); }

  const LocalSet* set_ = nullptr;
  ReduceWorkspace workspace_;
  index_t result_bytes_;
  Buffer gathered_, ordered_;
};

}  // namespace detail

}  // namespace physgen
