// The same objects on the host and on the device, of which a round trip moves only those that changed.
#pragma once

#include <physgen/array.h>

#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace physgen {

/// One of the two arrays of a Mirror.
enum class Side : std::uint8_t { host, device };

namespace detail {

/// Objects begin .. end-1.
struct ObjectRange {
  index_t begin;
  index_t end;
  bool operator==(const ObjectRange&) const = default;
};

/// Some of the objects of an array, as ranges that neither touch nor overlap.
class ObjectSet {
 public:
  /// Whether it has one of begin .. end-1, and the first such range of them.
  [[nodiscard]] std::optional<ObjectRange> first_in(index_t begin, index_t end) const;
  /// What it has of begin .. end-1, in order.
  [[nodiscard]] std::vector<ObjectRange> in(index_t begin, index_t end) const;
  /// Adds begin .. end-1; takes the time of a search, and of the ranges that it joins. @pre begin < end
  void add(index_t begin, index_t end);
  /// Removes begin .. end-1. @pre begin < end
  void remove(index_t begin, index_t end);

 private:
  std::map<index_t, index_t> ends_;  // of each range, by its beginning
};

/// Which objects of a mirror are newer on which side: exactly those that were written there.
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

  /// What to copy from `side` so that `ranges`, which newer() gave, are up to date on the other: those themselves; or,
  /// where a copy gives the other side what it had of all objects that are the same, whole blocks, as far as they
  /// hold nothing that is newer there, so that few transfers do.
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

}  // namespace detail

/// Objects of a block, which moves whole where that changes nothing: whole tiles and whole packs, and transfers long
/// enough to run at the rate of the bus.
inline constexpr index_t mirror_block = 4096;

/// A host array and a device array of the same objects. Who says what is written, and asks before reading, moves no
/// more than changed:
///
///   Mirror<NodePositionArray<float, PinnedHost>, NodePositionArray<float, Cuda>> x(n);
///   auto host = x.write_host(first, last);   // moves nothing; write objects first .. last-1
///   auto device = x.read_device();           // moves these objects
///
/// Each call names the objects that it is for; what it returns may be used for them until the next call. What lies in
/// other objects may be out of date. A side whose objects are newer on the other must read them before it writes them,
/// so no object is ever newer on both sides.
///
/// An object that one side never wrote keeps every bit that it has on the other, also where the sides differ in
/// precision or format: then exactly the written ranges move, each by itself. Where the formats are the same, whole
/// blocks of mirror_block objects move instead, as far as the other side holds nothing newer there.
/// @tparam HostArray_, DeviceArray_ arrays of one object type; any spaces, layouts and precisions
template <class HostArray_, class DeviceArray_>
class Mirror {
 public:
  using HostArray = HostArray_;
  using DeviceArray = DeviceArray_;

  Mirror() = default;
  /// `size` objects with initial values on both sides.
  /// @throw Error when size is negative or the memory cannot be had
  explicit Mirror(index_t size) : host_(size), device_(size), changed_(size, host_.untyped().object) {}
  /// The objects of `host`, all of them newer there.
  /// @throw Error when the memory cannot be had
  explicit Mirror(HostArray host)
      : host_(std::move(host)), device_(host_.size()), changed_(host_.size(), host_.untyped().object) {
    changed_.mark(Side::host, 0, size());
  }
  Mirror(const Mirror&) = default;
  Mirror(Mirror&& other) noexcept { swap(other); }
  Mirror& operator=(Mirror other) noexcept {
    swap(other);
    return *this;
  }
  ~Mirror() = default;

  [[nodiscard]] index_t size() const { return host_.size(); }

  /// For writing objects begin .. end-1 of one side, or all. Moves nothing.
  /// @throw Error when there are no such objects, or some are newer on the other side and have not been read on this
  ///        one: the message names the first. Nothing is changed then.
  [[nodiscard]] typename HostArray::View write_host(index_t begin, index_t end) {
    changed_.mark(Side::host, begin, end);
    return host_.view();
  }
  [[nodiscard]] typename HostArray::View write_host() { return write_host(0, size()); }
  [[nodiscard]] typename DeviceArray::View write_device(index_t begin, index_t end) {
    changed_.mark(Side::device, begin, end);
    return device_.view();
  }
  [[nodiscard]] typename DeviceArray::View write_device() { return write_device(0, size()); }

  /// For reading objects begin .. end-1 of one side, or all, after those that are newer on the other side have been
  /// copied. The copies are ordered in `stream` and done on return: give the stream in which kernels work on the
  /// device's objects.
  /// @throw Error when there are no such objects or a copy fails; the other side's objects then stay the newer ones
  [[nodiscard]] typename HostArray::ConstView read_host(index_t begin, index_t end, Stream stream = nullptr) {
    update(host_.untyped(), device_.untyped(), Side::device, begin, end, stream);
    return host_.const_view();
  }
  [[nodiscard]] typename HostArray::ConstView read_host(Stream stream = nullptr) {
    return read_host(0, size(), stream);
  }
  [[nodiscard]] typename DeviceArray::ConstView read_device(index_t begin, index_t end, Stream stream = nullptr) {
    update(device_.untyped(), host_.untyped(), Side::host, begin, end, stream);
    return device_.const_view();
  }
  [[nodiscard]] typename DeviceArray::ConstView read_device(Stream stream = nullptr) {
    return read_device(0, size(), stream);
  }

  /// Gives the host array away, all its objects up to date, for changes of topology; Mirror(HostArray) takes it back.
  /// The mirror is then empty.
  /// @throw Error when a copy fails; the mirror is then unchanged
  [[nodiscard]] HostArray release_host(Stream stream = nullptr) {
    (void)read_host(stream);
    Mirror emptied;
    swap(emptied);
    return std::move(emptied.host_);
  }

  /// Bytes copied between the two sides since the mirror was made, as copy_range() counts them.
  [[nodiscard]] index_t bytes_moved() const { return bytes_moved_; }

  void swap(Mirror& other) noexcept {
    host_.swap(other.host_);
    device_.swap(other.device_);
    std::swap(changed_, other.changed_);
    std::swap(bytes_moved_, other.bytes_moved_);
  }

 private:
  void update(const UntypedArray& to, const UntypedArray& from, Side newer, index_t begin, index_t end, Stream stream) {
    auto ranges = changed_.newer(newer, begin, end);
    if (ranges.empty()) return;
    if (to.space != SpaceKind::host || from.space != SpaceKind::host) {
      detail::refuse_capture(stream, "reading what is newer on the other side of a mirror");
    }
    if (detail::same_formats(to, from)) ranges = changed_.widened(newer, ranges);
    index_t bytes = 0;
    for (const auto& range : ranges) bytes += copy_range(to, from, range.begin, range.end, stream);
    if (to.space != SpaceKind::host || from.space != SpaceKind::host) synchronize(stream);
    for (const auto& range : ranges) changed_.settle(range);
    bytes_moved_ += bytes;
  }

  HostArray host_;
  DeviceArray device_;
  detail::ChangedObjects changed_;
  index_t bytes_moved_ = 0;
};

}  // namespace physgen
