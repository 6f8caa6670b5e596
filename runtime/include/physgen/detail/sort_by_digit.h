// One pass of a radix sort on all threads.
#pragma once

#include <physgen/detail/launch.h>
#include <physgen/detail/scan.h>
#include <physgen/error.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace physgen::detail {

inline void check_one_value_for_each(std::size_t keys, std::size_t values) {
  if (values == keys) return;
  throw Error("sort_by_key(): there are " + std::to_string(keys) + " keys and " + std::to_string(values) +
              " values; give one value for each key");
}

/// The key as bits that ascend as it does.
template <std::integral Key>
[[nodiscard]] constexpr auto ascending_bits(Key key) {
  using Bits = std::make_unsigned_t<Key>;
  constexpr Bits sign = std::is_signed_v<Key> ? Bits{1} << (std::numeric_limits<Bits>::digits - 1) : Bits{0};
  return static_cast<Bits>(static_cast<Bits>(key) ^ sign);
}

/// A stable counting sort by the eight bits from `shift` on.
/// @pre `to` has as many elements as `from`
template <class Key, class Value>
class SortByDigit {
 public:
  explicit SortByDigit(index_t size)
      : size_(size), blocks_(std::clamp<index_t>(size / least_block, 1, most_blocks)), counts_(blocks_ * digits) {}

  void operator()(int shift, const Key* keys, const Value* values, Key* keys_to, Value* values_to) {
    const auto digit = [shift](Key key) { return static_cast<index_t>(ascending_bits(key) >> shift & (digits - 1)); };
    for_each_index<least_block>(0, blocks_, [&](index_t b) {
      std::array<index_t, digits> count{};
      for (index_t i = begin_of(b); i < begin_of(b + 1); ++i) ++count[static_cast<std::size_t>(digit(keys[i]))];
      for (index_t d = 0; d < digits; ++d) at(d, b) = count[static_cast<std::size_t>(d)];
    });
    scan<false>(std::span(counts_));
    for_each_index<least_block>(0, blocks_, [&](index_t b) {
      std::array<index_t, digits> next;
      for (index_t d = 0; d < digits; ++d) next[static_cast<std::size_t>(d)] = at(d, b);
      for (index_t i = begin_of(b); i < begin_of(b + 1); ++i) {
        const index_t place = next[static_cast<std::size_t>(digit(keys[i]))]++;
        keys_to[place] = keys[i];
        values_to[place] = values[i];
      }
    });
  }

 private:
  static constexpr index_t digits = 256, least_block = index_t{1} << 14, most_blocks = 256;

  [[nodiscard]] index_t begin_of(index_t block) const { return size_ * block / blocks_; }
  [[nodiscard]] index_t& at(index_t d, index_t b) { return counts_[static_cast<std::size_t>(d * blocks_ + b)]; }

  index_t size_, blocks_;
  std::vector<index_t> counts_;  ///< per digit: of each block
};

}  // namespace physgen::detail
