// What CUB does for the library, in memory that the caller has: sums, scans and sorts of lists in CUDA memory.
#pragma once

#include <physgen/detail/device_lists.h>

#include <utility>

namespace physgen::cuda {

/// Memory of the device that lists are taken from, one behind the other. Of null memory, it counts the bytes they take.
class Lists {
 public:
  explicit Lists(std::byte* memory) : begin_(memory) {}
  template <class T>
  [[nodiscard]] T* take(index_t count) {
    constexpr index_t alignment = 256;
    const index_t offset = std::exchange(used_, used_ + align_up(count * index_t{sizeof(T)}, alignment));
    return begin_ == nullptr ? nullptr : reinterpret_cast<T*>(begin_ + offset);
  }
  [[nodiscard]] index_t used() const { return used_; }

 private:
  std::byte* begin_;
  index_t used_ = 0;
};

/// Memory of the device for what an algorithm keeps while it runs.
struct Workspace {
  std::byte* data;
  index_t bytes;
};

/// Bytes that sum() and scan() need.
[[nodiscard]] index_t workspace_of_scan(const detail::NumberList& numbers);
/// The sum of all numbers; waits for it.
[[nodiscard]] index_t sum(const detail::NumberList& numbers, const Workspace& workspace, Stream stream);
/// Each number becomes the sum of all before it. Does not wait.
void scan(const detail::NumberList& numbers, const Workspace& workspace, Stream stream);

/// Keys and their values, each in one of two lists, between which they go back and forth.
/// @tparam Key std::uint32_t or std::uint64_t
template <class Key>
struct Pairs {
  Key *keys, *other_keys;
  std::uint32_t *values, *other_values;
  index_t size;  ///< below 2^32
};
template <class Key>
[[nodiscard]] index_t workspace_of_sort(index_t size);
/// Sorts by the lowest `bits` bits of the keys, ascending; equal keys keep their order. `keys` and `values` are then
/// what is sorted. Does not wait.
template <class Key>
void sort(Pairs<Key>& pairs, int bits, const Workspace& workspace, Stream stream);

}  // namespace physgen::cuda
