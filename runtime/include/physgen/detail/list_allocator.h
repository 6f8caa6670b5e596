// The memory of lists: new elements have no value until a thread gives them one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace physgen::detail {

/// Memory of the host for `count` objects of so many bytes, in huge pages where it is large.
/// @throw MemoryError with the bytes when it cannot be had
[[nodiscard]] void* allocate_list(std::size_t count, std::size_t bytes_of_each);
void free_list(void* memory) noexcept;

template <class T>
struct ListAllocator {
  using value_type = T;

  ListAllocator() = default;
  template <class U>
  explicit ListAllocator(const ListAllocator<U>& /*other*/) noexcept {}

  [[nodiscard]] T* allocate(std::size_t count) { return static_cast<T*>(allocate_list(count, sizeof(T))); }
  void deallocate(T* memory, std::size_t /*count*/) noexcept { free_list(memory); }
  template <class U>
  void construct(U* place) noexcept {
    ::new (static_cast<void*>(place)) U;
  }
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }
  bool operator==(const ListAllocator& /*other*/) const = default;
};

template <class T>
bool operator==(const std::vector<T, ListAllocator<T>>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

}  // namespace physgen::detail
