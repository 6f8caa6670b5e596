// Sorts keys of a fixed size, and what belongs to them.
#pragma once

#include <physgen/memory/host_list.h>
#include <physgen/scan.h>

#include <array>
#include <atomic>
#include <type_traits>

namespace physgen {

namespace detail {

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

}  // namespace detail

/// Sorts keys, ascending, and moves the value of each along with it; equal keys keep their order. Takes a pass over all
/// for each byte in which keys differ, on threads() threads, and as much memory again for a while. The result does not
/// depend on the number of threads.
/// @pre there are as many values as keys
template <std::integral Key, class Value>
  requires std::is_trivially_copyable_v<Value>
void sort_by_key(Host /*space*/, std::span<Key> keys, std::span<Value> values) {
  const auto size = static_cast<index_t>(keys.size());
  if (values.size() != keys.size()) {
    throw Error("sort_by_key(): there are " + std::to_string(keys.size()) + " keys and " +
                std::to_string(values.size()) + " values; give one value for each key");
  }
  if (size < 2) return;
  using Bits = std::make_unsigned_t<Key>;
  std::atomic<Bits> differing = 0;
  detail::for_parts(size, [&](index_t begin, index_t end) {
    Bits bits = 0;
    for (index_t i = begin; i < end; ++i) {
      bits = static_cast<Bits>(bits | static_cast<Bits>(keys[static_cast<std::size_t>(i)] ^ keys.front()));
    }
    differing |= bits;
  });
  HostList<Key> other_keys(keys.size());
  HostList<Value> other_values(keys.size());
  detail::SortByDigit<Key, Value> sort(size);
  Key *from = keys.data(), *to = other_keys.data();
  Value *values_from = values.data(), *values_to = other_values.data();
  for (int shift = 0; shift < std::numeric_limits<Bits>::digits; shift += 8) {
    if ((differing.load() >> shift & 0xFF) == 0) continue;
    sort(shift, from, values_from, to, values_to);
    std::swap(from, to);
    std::swap(values_from, values_to);
  }
  if (from == keys.data()) return;
  detail::for_each_index(0, size, [&](index_t i) {
    to[i] = from[i];
    values_to[i] = values_from[i];
  });
}

}  // namespace physgen
