// A search on several threads: what is wrong is named by its lowest number, whichever thread finds it.
#pragma once

#include <physgen/detail/launch.h>

namespace physgen::detail {

/// The lowest of 0 .. size-1 for which a condition holds; `size` where there is none.
/// @param condition throws nothing
template <class Condition>
[[nodiscard]] index_t first_index(index_t size, const Condition& condition) {
  std::atomic<index_t> first = size;
  for_parts(size, [&](index_t begin, index_t end) {
    index_t i = begin;
    while (i < end && !condition(i)) ++i;
    if (i == end) return;
    for (index_t lowest = first; i < lowest && !first.compare_exchange_weak(lowest, i);) {
    }
  });
  return first;
}

}  // namespace physgen::detail
