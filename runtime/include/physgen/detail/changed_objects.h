// Remembers which objects of a mirror are newer on which side.
#pragma once

#include <physgen/arrays/untyped_array.h>

#include <map>
#include <optional>
#include <string_view>
#include <vector>

namespace physgen {

/// One of the two arrays of a Mirror.
enum class Side : std::uint8_t { host, device };

/// Objects of a block, which moves whole where that changes nothing: whole tiles and whole packs, and transfers long
/// enough to run at the rate of the bus.
inline constexpr index_t mirror_block = 4096;

}  // namespace physgen

namespace physgen::detail {

/// Objects begin .. end-1.
struct ObjectRange {
  index_t begin;
  index_t end;
  bool operator==(const ObjectRange&) const = default;
};

/// Some of the objects of an array, as ranges that neither touch nor overlap.
class ObjectSet {
 public:
  /// The first range that it has of begin .. end-1, if there is one.
  [[nodiscard]] std::optional<ObjectRange> first_in(index_t begin, index_t end) const;
  /// All such ranges, in order.
  [[nodiscard]] std::vector<ObjectRange> in(index_t begin, index_t end) const;
  /// Adds begin .. end-1; takes the time of a search, and of the ranges that it joins. @pre begin < end
  void add(index_t begin, index_t end);
  /// Removes begin .. end-1. @pre begin < end
  void remove(index_t begin, index_t end);

 private:
  std::map<index_t, index_t> ends_;  // of each range, by its beginning
};

/// Remembers which objects of a mirror were written on which side and are newer there.
class ChangedObjects {
 public:
  ChangedObjects() = default;
  /// `size` objects that are the same on both sides. @param object its name, for messages
  ChangedObjects(index_t size, std::string_view object) : size_(size), object_(object) {}

  /// Notes that objects begin .. end-1 are written on `side`.
  /// @throw Error when there are no such objects, or some are newer on the other side; nothing is noted
  void mark(Side side, index_t begin, index_t end);

  /// The objects of begin .. end-1 that are newer on `side`, in order.
  /// @throw Error when there are no such objects
  [[nodiscard]] std::vector<ObjectRange> newer(Side side, index_t begin, index_t end) const;

  /// Widens `ranges`, which newer() gave for `side`, to whole blocks as far as these hold nothing that is newer on the
  /// other side, so that few transfers bring it up to date.
  /// @pre a copy of objects that are the same on both sides changes no bit of them
  [[nodiscard]] std::vector<ObjectRange> widened(Side side, const std::vector<ObjectRange>& ranges) const;

  /// Notes that both sides hold the same objects in `range`.
  void settle(const ObjectRange& range);

 private:
  void check_range(index_t begin, index_t end) const;
  [[nodiscard]] const ObjectSet& newer_on(Side side) const { return side == Side::host ? on_host_ : on_device_; }

  index_t size_ = 0;
  std::string_view object_;
  ObjectSet on_host_, on_device_;  // without common objects
};

/// Whether both store every element in the same format, so that copies both ways change no bit.
[[nodiscard]] bool same_formats(const UntypedArray& a, const UntypedArray& b);

}  // namespace physgen::detail
