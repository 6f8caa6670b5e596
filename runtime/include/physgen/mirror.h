// The same objects on the host and on the device, of which a round trip moves only those that changed.
#pragma once

#include <physgen/array.h>

#include <string_view>
#include <utility>
#include <vector>

namespace physgen {

/// One of the two arrays of a Mirror.
enum class Side : std::uint8_t { host, device };

namespace detail {

/// Which side of a mirror holds the newer objects, block by block.
class ChangedBlocks {
 public:
  ChangedBlocks() = default;
  /// `size` objects that are the same on both sides. @param object its name, for messages
  ChangedBlocks(index_t size, std::string_view object);

  /// Notes that objects begin .. end-1 are written on `side`.
  /// @throw Error when there are no such objects, or one of their blocks is newer on the other side; nothing is noted
  void mark(Side side, index_t begin, index_t end);

  struct Range {
    index_t begin;
    index_t end;
  };
  /// The blocks that hold objects of begin .. end-1 and are newer on `side`, neighbours joined.
  /// @throw Error when there are no such objects
  [[nodiscard]] std::vector<Range> newer(Side side, index_t begin, index_t end) const;

  /// Notes that both sides hold the same objects in `range`, which newer() gave.
  void settle(const Range& range);

 private:
  enum class State : std::uint8_t { same, newer_on_host, newer_on_device };

  [[nodiscard]] static State newer_on(Side side) {
    return side == Side::host ? State::newer_on_host : State::newer_on_device;
  }
  void check_range(index_t begin, index_t end) const;
  [[nodiscard]] Range objects_of(std::size_t block) const;

  index_t size_ = 0;
  std::string_view object_;
  std::vector<State> blocks_;
};

}  // namespace detail

/// Objects per block: whole tiles and whole packs, and transfers long enough to run at the rate of the bus.
inline constexpr index_t mirror_block = 4096;

/// A host array and a device array of the same objects. Who says what is written, and asks before reading, moves no
/// more than changed, in blocks of mirror_block objects:
///
///   Mirror<NodePositionArray<float, PinnedHost>, NodePositionArray<float, Cuda>> x(n);
///   auto host = x.write_host(first, last);   // moves nothing; write objects first .. last-1
///   auto device = x.read_device();           // moves the blocks of these objects
///
/// Each call names the objects that it is for; what it returns may be used for them until the next call. What lies in
/// other objects may be out of date. A side whose objects are newer on the other must read before it writes, so no
/// object is ever newer on both sides.
/// @tparam HostArray_, DeviceArray_ arrays of one object type; any spaces, layouts and precisions
template <class HostArray_, class DeviceArray_>
class Mirror {
 public:
  using HostArray = HostArray_;
  using DeviceArray = DeviceArray_;

  Mirror() = default;
  /// `size` objects with initial values on both sides.
  /// @throw Error when size is negative or the memory cannot be had
  explicit Mirror(index_t size) : host_(size), device_(size), changed_(size, host_.storage().object) {}
  /// The objects of `host`, all of them newer there.
  /// @throw Error when the memory cannot be had
  explicit Mirror(HostArray host)
      : host_(std::move(host)), device_(host_.size()), changed_(host_.size(), host_.storage().object) {
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
  /// @throw Error when there are no such objects, or a block that holds some is newer on the other side and has not
  ///        been read on this one: the message names the block. Nothing is changed then.
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

  /// For reading objects begin .. end-1 of one side, or all, after the blocks that hold them and are newer on the other
  /// side have been copied. The copies are ordered in `stream` and done on return: give the stream in which kernels
  /// work on the device's objects.
  /// @throw Error when there are no such objects or a copy fails; the other side's blocks then stay the newer ones
  [[nodiscard]] typename HostArray::ConstView read_host(index_t begin, index_t end, Stream stream = nullptr) {
    update(host_.storage(), device_.storage(), Side::device, begin, end, stream);
    return host_.const_view();
  }
  [[nodiscard]] typename HostArray::ConstView read_host(Stream stream = nullptr) {
    return read_host(0, size(), stream);
  }
  [[nodiscard]] typename DeviceArray::ConstView read_device(index_t begin, index_t end, Stream stream = nullptr) {
    update(device_.storage(), host_.storage(), Side::host, begin, end, stream);
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
  void update(const Storage& to, const Storage& from, Side newer, index_t begin, index_t end, Stream stream) {
    const auto ranges = changed_.newer(newer, begin, end);
    if (ranges.empty()) return;
    index_t bytes = 0;
    for (const auto& range : ranges) bytes += copy_range(to, from, range.begin, range.end, stream);
    if (to.space != SpaceKind::host || from.space != SpaceKind::host) synchronize(stream);
    for (const auto& range : ranges) changed_.settle(range);
    bytes_moved_ += bytes;
  }

  HostArray host_;
  DeviceArray device_;
  detail::ChangedBlocks changed_;
  index_t bytes_moved_ = 0;
};

}  // namespace physgen
