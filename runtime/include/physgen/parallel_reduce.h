// Runs a kernel over objects on the CPU and folds what it returns into one value: see reduce.h for folds and the order.
#pragma once

#include <physgen/detail/host_reduction.h>
#include <physgen/launch/reduce.h>
#include <physgen/parallel_for.h>

#include <memory>

namespace physgen {

/// Calls kernel(i) for the objects begin .. end-1, on threads() threads, as parallel_for() does, and folds what the
/// calls return. The kernel may also store fields.
/// @tparam Fold Sum, Max, Min, Argmax, All, Any, Count, or one's own; see reduce.h
/// @return the fold's Value, or of several terms a std::array or Eigen matrix of them
/// @throw what a call throws (the first to be caught), after all other calls have been made
template <class Kernel, class Fold>
  requires(!std::is_integral_v<Kernel>)
auto parallel_reduce(Host /*space*/, index_t begin, index_t end, const Kernel& kernel, Fold /*fold*/) {
  constexpr int width = detail::lanes_of_calls<Kernel>();
  using Index = std::conditional_t<width == 1, index_t, Pack<width>>;
  using Types = detail::Reduction<Kernel, Fold, Index>;
  using Value = typename Types::Value;
  constexpr auto count = static_cast<std::size_t>(Types::count);

  if constexpr (width == 1) detail::check_numbers(kernel);
  detail::check_range_of_launch(begin);
  const detail::RunLanes outer({});  // where a kernel calls this
  const index_t blocks = detail::blocks_of(begin, end), first = begin / detail::reduce_block;
  const auto size = static_cast<std::size_t>(blocks);
  const auto values = std::make_unique_for_overwrite<Value[]>(size * count);  // an entry's blocks follow each other
  detail::LaunchFailure failure;
  detail::for_each_index<detail::reduce_block>(0, blocks, [&](index_t b) {
    const index_t at = (first + b) * detail::reduce_block;
    std::array<Value, count> of_block;
    detail::reduce_one_block<Fold, width>(std::max(at, begin), std::min(at + detail::reduce_block, end), kernel,
                                          failure, of_block.data());
    for (std::size_t k = 0; k < count; ++k) values[k * size + static_cast<std::size_t>(b)] = of_block[k];
  });
  failure.rethrow();
  std::array<Value, count> result;
  for (std::size_t k = 0; k < count; ++k) {
    result[k] = detail::join_blocks<Fold, typename Types::Number>(values.get() + k * size, blocks);
  }
  return Types::Entries::result(result.data());
}

/// The same for the objects 0 .. size-1.
template <class Kernel, class Fold>
  requires(!std::is_integral_v<Kernel>)
auto parallel_reduce(Host space, index_t size, const Kernel& kernel, Fold fold) {
  return parallel_reduce(space, 0, size, kernel, fold);
}

}  // namespace physgen
