// Sums of all numbers before each: where the parts of a list begin whose lengths are known.
#pragma once

#include <physgen/detail/scan.h>
#include <physgen/memory/space.h>

#include <concepts>
#include <span>

namespace physgen {

/// Each number becomes the sum of all before it; the first becomes 0. Of the lengths of rows, and a 0 behind them, that
/// makes where each row begins and the last one ends. Runs on threads() threads.
/// @pre no number is negative
/// @return the sum of all
/// @throw Error with the sum when it exceeds the largest Number; the numbers are then as they were
template <std::integral Number>
index_t exclusive_scan(Host /*space*/, std::span<Number> numbers) {
  return detail::scan<false>(numbers);
}

}  // namespace physgen
