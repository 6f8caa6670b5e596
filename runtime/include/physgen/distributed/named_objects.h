// What objects name, many of them at a time: one call finds it of a batch of objects, into lists that are used again.
#pragma once

#include <physgen/config.h>

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace physgen::detail {

/// The numbers that some objects name, object by object.
class NamedNumbers {
 public:
  void clear() {
    numbers_.clear();
    ends_.clear();
  }
  /// Of the object that end_object() ends.
  void add(index_t number) { numbers_.push_back(number); }
  void end_object() { ends_.push_back(numbers_.size()); }
  [[nodiscard]] std::size_t objects() const { return ends_.size(); }
  [[nodiscard]] std::span<const index_t> of(std::size_t object) const {
    const std::size_t begin = object == 0 ? 0 : ends_[object - 1];
    return std::span(numbers_).subspan(begin, ends_[object] - begin);
  }

 private:
  std::vector<index_t> numbers_;
  std::vector<std::size_t> ends_;
};

/// Appends what each of some objects names, by global numbers; called by several threads at once.
using NamedObjects = std::function<void(std::span<const index_t> objects, NamedNumbers& numbers)>;

}  // namespace physgen::detail
