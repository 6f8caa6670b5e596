// Sorts keys of a fixed size, and what belongs to them.
#pragma once

#include <physgen/detail/device_lists.h>
#include <physgen/detail/sort_by_digit.h>
#include <physgen/memory/host_list.h>
#include <physgen/memory/space.h>

#include <atomic>
#include <concepts>
#include <limits>
#include <span>
#include <type_traits>

namespace physgen {

/// Sorts keys, ascending, and moves the value of each along with it; equal keys keep their order. Takes a pass over all
/// for each byte in which keys differ, on threads() threads, and as much memory again for a while. The result does not
/// depend on the number of threads.
/// @pre there are as many values as keys
template <std::integral Key, class Value>
  requires std::is_trivially_copyable_v<Value>
void sort_by_key(Host /*space*/, std::span<Key> keys, std::span<Value> values) {
  detail::check_one_value_for_each(keys.size(), values.size());
  const auto size = static_cast<index_t>(keys.size());
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

/// The same of keys and values in CUDA memory, ordered in `stream`; does not wait. It takes a pass for each byte of a
/// key, differing or not.
/// @throw Error also when there are more than 2^32 - 1 keys, when CUDA fails, and in a program that has physgen without
/// CUDA
template <std::integral Key, class Value>
  requires std::is_trivially_copyable_v<Value>
void sort_by_key(Cuda /*space*/, std::span<Key> keys, std::span<Value> values, Stream stream = nullptr) {
  detail::check_one_value_for_each(keys.size(), values.size());
  detail::sort(detail::NumberList(keys), detail::ValueList(values), stream);
}

}  // namespace physgen
