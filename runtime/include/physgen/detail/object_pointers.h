// Checks of pointers to objects that a simulator allocated one by one.
#pragma once

#include <physgen/config.h>
#include <physgen/detail/launch.h>
#include <physgen/error.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <numeric>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace physgen::detail {

template <class T>
void check_not_null(std::span<T* const> objects, std::string_view object_type) {
  const auto count = static_cast<index_t>(objects.size());
  T* const* pointers = objects.data();
  std::atomic<bool> missing = false;
  for_parts(count, [pointers, &missing](index_t begin, index_t end) {
    if (std::find(pointers + begin, pointers + end, nullptr) != pointers + end) missing = true;
  });
  if (missing) {
    const auto first = std::find(objects.begin(), objects.end(), nullptr) - objects.begin();
    throw Error(std::string(object_type) + ": pointer " + std::to_string(first) + " of " + std::to_string(count) +
                " is null; every object needs one");
  }
}

/// Two threads would write one object. @throw Error naming the first pointer that is there a second time
template <class T>
void check_different(std::span<T* const> objects, std::string_view object_type) {
  std::vector<std::size_t> order(objects.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return objects[a] != objects[b] ? std::less<>()(objects[a], objects[b]) : a < b;
  });
  std::size_t first = 0, second = objects.size();
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (objects[order[k]] != objects[order[k - 1]] || order[k] >= second) continue;
    first = order[k - 1];
    second = order[k];
  }
  if (second == objects.size()) return;
  throw Error(std::string(object_type) + ": pointers " + std::to_string(first) + " and " + std::to_string(second) +
              " of " + std::to_string(objects.size()) + " are the same; an object is scattered to once");
}

}  // namespace physgen::detail
