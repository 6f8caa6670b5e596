// What objects name, many of them at a time: one call finds it of a piece of them, into lists that are used again; and
// the bounds of what a group of objects names, so that groups which name nothing of others need not be asked.
#pragma once

#include <physgen/config.h>
#include <physgen/error.h>

#include <algorithm>
#include <atomic>
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

/// Objects of a set that follow each other, by global numbers: first .. last-1, of one group.
struct ObjectPiece {
  static constexpr index_t group = 256;  ///< objects, of which the first has a multiple as its number
  index_t first, last;
  index_t place;  ///< of the first, among the objects of all pieces of a list

  [[nodiscard]] index_t size() const { return last - first; }
};

/// What a group of objects names, altogether.
struct NamedBounds {
  index_t low = std::numeric_limits<index_t>::max();  ///< the lowest number, where -1 counts, too
  index_t high = std::numeric_limits<index_t>::min();
  index_t fewest = std::numeric_limits<index_t>::max();  ///< numbers of an object; as it is before they are counted

  [[nodiscard]] bool are_none() const { return low > high; }
};

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
  NamedObjects() = default;
  /// @param visit visit(use) calls use(each), where each(object, act) calls act(number) for each number that an object
  /// names, by global numbers, -1 for none; called by several threads at once
  template <class Visit>
  NamedObjects(std::string field, KnownObjects known, const Visit& visit) : field_(std::move(field)), known_(known) {
    tell_ = [visit](index_t first, index_t last, NamedNumbers& numbers) {
      visit([&](const auto& each) {
        for (index_t object = first; object < last; ++object) {
          each(object, [&](index_t number) { numbers.add(number); });
          numbers.end_object();
        }
      });
    };
    bound_ = [visit](index_t first, index_t last) {
      NamedBounds bounds;
      visit([&](const auto& each) {
        for (index_t object = first; object < last; ++object) {
          index_t count = 0;
          each(object, [&](index_t number) {
            bounds.low = std::min(bounds.low, number);
            bounds.high = std::max(bounds.high, number);
            ++count;
          });
          bounds.fewest = std::min(bounds.fewest, count);
        }
      });
      return bounds;
    };
  }

  [[nodiscard]] const std::string& field() const { return field_; }
  [[nodiscard]] const KnownObjects& known() const { return known_; }
  /// Makes room for the bounds of what the objects of a set name.
  void keep_bounds(index_t size) {
    known_.last = std::min(known_.last, size);
    known_.first = std::min(known_.first, known_.last);
    first_group_ = known_.first / ObjectPiece::group;
    const index_t behind = (known_.last + ObjectPiece::group - 1) / ObjectPiece::group;
    bounds_.resize(static_cast<std::size_t>(std::max(behind - first_group_, index_t{0})));
  }
  /// @throw Error when an object is not known
  void require_known(index_t object) const {
    if (known_.has(object)) return;
    throw Error(field_ + " of object " + std::to_string(object) + " is needed on a rank that knows those of " +
                std::to_string(known_.first) + " .. " + std::to_string(known_.last - 1) +
                "; let the rank know more objects");
  }
  /// Of all known objects of the group of a piece. They are found when they are asked for first.
  /// @pre keep_bounds() @throw Error when an object of the piece is not known
  [[nodiscard]] NamedBounds bounds_of(const ObjectPiece& piece) const {
    require_known(piece.first);
    require_known(piece.last - 1);
    const index_t group = piece.first / ObjectPiece::group;
    NamedBounds& kept = bounds_[static_cast<std::size_t>(group - first_group_)];
    // Pieces of a group may be those of several threads, which find the same; what is kept is whole where its last
    // number is.
    const std::atomic_ref low(kept.low), high(kept.high), fewest(kept.fewest);
    NamedBounds bounds;
    bounds.fewest = fewest.load(std::memory_order_acquire);
    if (bounds.fewest != NamedBounds().fewest) {
      bounds.low = low.load(std::memory_order_relaxed);
      bounds.high = high.load(std::memory_order_relaxed);
      return bounds;
    }
    bounds = bound_(std::max(known_.first, group * ObjectPiece::group),
                    std::min(known_.last, (group + 1) * ObjectPiece::group));
    low.store(bounds.low, std::memory_order_relaxed);
    high.store(bounds.high, std::memory_order_relaxed);
    fewest.store(bounds.fewest, std::memory_order_release);
    return bounds;
  }
  /// Appends what each object names. @throw Error when one is not known
  void operator()(const ObjectPiece& piece, NamedNumbers& numbers) const {
    require_known(piece.first);
    require_known(piece.last - 1);
    tell_(piece.first, piece.last, numbers);
  }

 private:
  std::string field_;
  KnownObjects known_;
  std::function<void(index_t first, index_t last, NamedNumbers& numbers)> tell_;
  std::function<NamedBounds(index_t first, index_t last)> bound_;
  index_t first_group_ = 0;
  mutable std::vector<NamedBounds> bounds_;  ///< of each group of known objects
};

}  // namespace physgen::detail
