// Sums of all numbers before each: where the parts of a list begin whose lengths are known.
#pragma once

#include <physgen/detail/device_lists.h>
#include <physgen/detail/scan.h>
#include <physgen/memory/space.h>

#include <span>

namespace physgen {

/// Each number becomes the sum of all before it; the first becomes 0. Of the lengths of rows, and a 0 behind them, that
/// makes where each row begins and the last one ends. Runs on threads() threads.
/// @tparam Number an integer of up to 64 bits that an index_t holds
/// @pre no number is negative
/// @return the sum of all
/// @throw Error with the sum when it exceeds the largest Number; the numbers are then as they were
template <detail::Countable Number>
index_t exclusive_scan(Host /*space*/, std::span<Number> numbers) {
  return detail::scan<false>(numbers);
}

/// The same of numbers in CUDA memory, ordered in `stream`. It waits for the sum of all, but not for the others.
/// @throw Error also when CUDA fails, and in a program that has physgen without CUDA
template <detail::Countable Number>
index_t exclusive_scan(Cuda /*space*/, std::span<Number> numbers, Stream stream = nullptr) {
  return detail::scan(detail::NumberList(numbers), stream);
}

}  // namespace physgen
