// The sums of exclusive_scan(), block by block.
#pragma once

#include <physgen/config.h>
#include <physgen/detail/device_lists.h>
#include <physgen/detail/launch.h>
#include <physgen/error.h>

#include <algorithm>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace physgen::detail {

/// @param most the largest of a list's numbers
inline void check_total(index_t total, index_t most) {
  if (total <= most) return;
  throw Error("a list would have " + std::to_string(total) + " entries, and its numbers reach " + std::to_string(most) +
              ": make fewer, or spread them over several lists");
}

/// Each number becomes the sum of those before it, and itself where the scan is inclusive. See exclusive_scan().
template <bool kInclusive, Countable Number>
index_t scan(std::span<Number> numbers) {
  constexpr index_t block = index_t{1} << 14;
  const auto size = static_cast<index_t>(numbers.size());
  const index_t blocks = (size + block - 1) / block;
  std::vector<index_t> before(static_cast<std::size_t>(blocks));  // of each block
  for_each_index<block / 4>(0, blocks, [&](index_t b) {
    index_t sum = 0;
    const index_t end = std::min(size, (b + 1) * block);
    for (index_t i = b * block; i < end; ++i) sum += index_t{numbers[static_cast<std::size_t>(i)]};
    before[static_cast<std::size_t>(b)] = sum;
  });
  index_t total = 0;
  for (index_t& sum : before) total += std::exchange(sum, total);
  check_total(total, index_t{std::numeric_limits<Number>::max()});
  for_each_index<block / 4>(0, blocks, [&](index_t b) {
    auto sum = static_cast<Number>(before[static_cast<std::size_t>(b)]);
    const index_t end = std::min(size, (b + 1) * block);
    for (index_t i = b * block; i < end; ++i) {
      Number& number = numbers[static_cast<std::size_t>(i)];
      const auto next = static_cast<Number>(sum + number);
      number = kInclusive ? next : sum;
      sum = next;
    }
  });
  return total;
}

}  // namespace physgen::detail
