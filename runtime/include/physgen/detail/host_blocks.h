// The two stages of a reduction on the CPU: the values of blocks, and the value of all of them. Several reductions may
// leave the values of their blocks side by side, and be joined as one.
#pragma once

#include <physgen/detail/check_numbers.h>
#include <physgen/detail/host_loop.h>
#include <physgen/detail/host_reduction.h>
#include <physgen/launch/in_lanes.h>

namespace physgen::detail {

/// What a kernel is called with on the CPU.
template <class Kernel>
using HostIndex = std::conditional_t<lanes_of_calls<Kernel>() == 1, index_t, Pack<lanes_of_calls<Kernel>()>>;
template <class Kernel, class Fold>
using HostReduction = Reduction<Kernel, Fold, HostIndex<Kernel>>;

/// Calls kernel(i) for the objects begin .. end-1 and leaves the values of their blocks: that of block b, the first of
/// the range being 0, and of entry k at values[k * stride + b].
/// @param first the number by which folds know object `begin`: another one where the array is a part of a larger one.
/// @pre then both are multiples of reduce_block
/// @throw what a call throws (the first to be caught), after all other calls have been made
template <class Fold, class Kernel, class Value>
void reduce_blocks(index_t begin, index_t end, const Kernel& kernel, Value* values, index_t stride, index_t first) {
  constexpr int width = lanes_of_calls<Kernel>();
  constexpr auto count = static_cast<std::size_t>(HostReduction<Kernel, Fold>::count);
  if constexpr (width == 1) check_numbers(kernel);
  check_range_of_launch(begin);
  const RunLanes outer({});  // where a kernel calls this
  LaunchFailure failure;
  for_each_index<reduce_block>(0, blocks_of(begin, end), [&](index_t b) {
    const index_t at = (begin / reduce_block + b) * reduce_block;
    std::array<Value, count> of_block;
    reduce_one_block<Fold, width>(std::max(at, begin), std::min(at + reduce_block, end), kernel, failure, first - begin,
                                  of_block.data());
    for (std::size_t k = 0; k < count; ++k) values[static_cast<index_t>(k) * stride + b] = of_block[k];
  });
  failure.rethrow();
}

/// The result of blocks whose values lie as reduce_blocks() leaves them.
template <class Fold, class Types>
typename Types::Result join_entries(const typename Types::Value* values, index_t blocks) {
  std::array<typename Types::Value, static_cast<std::size_t>(Types::count)> result;
  for (std::size_t k = 0; k < result.size(); ++k) {
    result[k] = join_blocks<Fold, typename Types::Number>(values + static_cast<index_t>(k) * blocks, blocks);
  }
  return Types::Entries::result(result.data());
}

}  // namespace physgen::detail
