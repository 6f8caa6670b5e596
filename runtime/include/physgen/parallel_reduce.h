// Runs a kernel over objects on the CPU and folds what it returns into one value: see reduce.h for folds and the order.
#pragma once

#include <physgen/detail/host_blocks.h>
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
  using Types = detail::HostReduction<Kernel, Fold>;
  const index_t blocks = detail::blocks_of(begin, end);
  const auto count = static_cast<std::size_t>(blocks * Types::count);
  const auto values = std::make_unique_for_overwrite<typename Types::Value[]>(count);
  detail::reduce_blocks<Fold>(begin, end, kernel, values.get(), blocks, begin);
  return detail::join_entries<Fold, Types>(values.get(), blocks);
}

/// The same for the objects 0 .. size-1.
template <class Kernel, class Fold>
  requires(!std::is_integral_v<Kernel>)
auto parallel_reduce(Host space, index_t size, const Kernel& kernel, Fold fold) {
  return parallel_reduce(space, 0, size, kernel, fold);
}

}  // namespace physgen
