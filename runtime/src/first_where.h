// The first of many things that are looked at on several threads, such as the one that an Error names.
#pragma once

#include <physgen/detail/launch.h>

#include <atomic>

namespace physgen::detail {

/// The first i of 0 .. size-1 for which holds(i) is true, or size. Each is asked for, unless one before it holds.
template <class Holds>
[[nodiscard]] index_t first_where(index_t size, const Holds& holds) {
  std::atomic<index_t> first = size;
  for_parts(size, [&](index_t begin, index_t end) {
    index_t i = begin;
    while (i < end && !holds(i)) ++i;
    if (i == end) return;
    for (index_t smallest = first; i < smallest && !first.compare_exchange_weak(smallest, i);) {
    }
  });
  return first;
}

}  // namespace physgen::detail
