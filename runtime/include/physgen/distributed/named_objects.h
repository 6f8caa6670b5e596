// What objects name, many of them at a time: one call finds it of a batch of objects, into lists that are used again.
#pragma once

#include <physgen/config.h>
#include <physgen/error.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace physgen {

/// The objects of a set of which this rank can tell what they name, by global numbers: first .. last-1.
struct KnownObjects {
  index_t first = 0;
  index_t last = std::numeric_limits<index_t>::max();

  [[nodiscard]] bool has(index_t object) const { return first <= object && object < last; }
};

}  // namespace physgen

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

/// What the objects of a set name by a field.
class NamedObjects {
 public:
  /// Appends what each of some objects names, by global numbers; called by several threads at once.
  using Tell = std::function<void(std::span<const index_t> objects, NamedNumbers& numbers)>;

  NamedObjects() = default;
  NamedObjects(std::string field, KnownObjects known, Tell tell)
      : field_(std::move(field)), known_(known), tell_(std::move(tell)) {}

  [[nodiscard]] const KnownObjects& known() const { return known_; }
  /// @throw Error when an object is not known
  void require_known(index_t object) const {
    if (known_.has(object)) return;
    throw Error(field_ + " of object " + std::to_string(object) + " is needed on a rank that knows those of " +
                std::to_string(known_.first) + " .. " + std::to_string(known_.last - 1) +
                "; let the rank know more objects");
  }
  /// @param objects ascending @throw Error when one is not known
  void operator()(std::span<const index_t> objects, NamedNumbers& numbers) const {
    if (objects.empty()) return;
    require_known(objects.front());
    require_known(objects.back());
    tell_(objects, numbers);
  }

 private:
  std::string field_;
  KnownObjects known_;
  Tell tell_;
};

}  // namespace physgen::detail
