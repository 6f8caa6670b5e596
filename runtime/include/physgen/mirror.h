// The same objects on the host and on the device; a round trip moves only those that changed.
#pragma once

#include <physgen/arrays/array.h>
#include <physgen/detail/changed_objects.h>

#include <utility>

namespace physgen {

/// A host array and a device array of the same objects. A program that says what it writes, and asks before it reads,
/// moves no more than changed:
///
///   Mirror<NodePositionArray<float, PinnedHost>, NodePositionArray<float, Cuda>> x(n);
///   auto host = x.write_host(first, last);   // moves nothing; write objects first .. last-1
///   auto device = x.read_device();           // moves these objects
///
/// Each call names the objects that it is for; the view that it returns may be used for them until the next call. Other
/// objects may be out of date. A side whose objects are newer on the other must read them before it writes them,
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
