// An array without its types: base, counts, pitch, record and fields as data. Conversions between layouts, precisions
// and spaces are written once over it, not once per pair of types.
#pragma once

#include <physgen/layout/address.h>
#include <physgen/losses.h>
#include <physgen/object_info.h>
#include <physgen/space.h>

#include <span>
#include <string_view>

namespace physgen {

/// The memory of one array. Does not own it.
struct UntypedArray {
  std::byte* base = nullptr;
  index_t size = 0;    ///< objects
  index_t padded = 0;  ///< objects for which memory is held
  index_t pitch = 1;   ///< objects of a tile (layout/address.h)
  int record_bytes = 0;
  SpaceKind space = SpaceKind::host;
  std::string_view object;  ///< qualified name of the object type, for messages
  std::span<const FieldInfo> fields;

  [[nodiscard]] index_t bytes() const { return padded * record_bytes; }
  /// Where an element of object i lies, of `size` bytes and `offset` bytes into the record.
  [[nodiscard]] std::byte* address(index_t i, index_t offset, index_t size) const {
    return law::element(base, AnyPitch{pitch}, record_bytes, i, offset, size);
  }
};

// The rule of streams, for all operations of the library:
//   - An operation is ordered in the stream that it is given, or in the default stream where it takes none. It sees
//     what was ordered in that stream before it, and what is ordered there later sees its result, whichever spaces are
//     involved. So what the host does to pinned memory waits for the stream first. Ordinary host memory (Host) is
//     worked on while a call runs, never later.
//   - Access through a host view, a kernel on the host included, is no operation: before it, synchronize(stream).
//   - While a stream is captured in a graph, an operation that would wait or allocate throws an Error that says so, and
//     orders nothing. What remains: copies between arrays in CUDA memory, and copies without conversion between pinned
//     and CUDA memory; in checked builds only those of the latter kind.

/// Copies all objects of `from` to `to`, converting layout, storage format, precision and space in one pass. Where both
/// lie on the host, pinned or not, or one lies in host memory that is not pinned, it is done when this returns; else
/// only ordered in `stream`.
/// A field that `to` prunes is left out.
/// @throw Error when the sizes or the object types differ, an array is null, or they share memory; when `from` does not
/// store a field that `to` has, or `to` stores nothing of one without pruning it (format/nothing.h); in checked builds
/// also when a format cannot hold a value (losses_of_copy() falsifies one). `to` is then unchanged
void copy(const UntypedArray& to, const UntypedArray& from, Stream stream = nullptr);

/// What the formats of `to` could not hold of `from`: a look before a copy. On CUDA this is done when it returns.
/// @throw Error where their fields keep copy() from copying
/// @pre both describe the same object type; only the memory of `from` is read
[[nodiscard]] Losses losses_of_copy(const UntypedArray& to, const UntypedArray& from, Stream stream = nullptr);

/// @throw Error naming field, object and value where `losses` has falsified ones
void throw_if_falsified(const Losses& losses, const UntypedArray& array);

/// Reads counters, sets them to zero and tells them how many objects count. Waits for all work of the device.
[[nodiscard]] Losses take_losses(Losses& counters, index_t objects, SpaceKind space);

/// Sets up the counters of a new array: how many objects count, and what `old` has counted, unless it is null.
void start_losses(Losses& counters, const Losses* old, index_t objects, SpaceKind space);

/// Copies objects begin .. end-1 only, to the same numbers, as copy() does; the sizes may differ. Between spaces only
/// these objects are transferred.
/// @return bytes of the objects as they were transferred
/// @throw Error as copy(), and when there are no such objects in both arrays; `to` is then unchanged
index_t copy_range(const UntypedArray& to, const UntypedArray& from, index_t begin, index_t end,
                   Stream stream = nullptr);

/// Copies the first `count` objects only. @pre count <= both sizes
void copy_first(const UntypedArray& to, const UntypedArray& from, index_t count, Stream stream = nullptr);

/// Sets objects begin .. end-1, whose memory is zero as a new Buffer's is, to their fields' initial values.
/// @pre 0 <= begin <= end <= array.padded
void initialize(const UntypedArray& array, index_t begin, index_t end);

/// Element k (counted over the fields in order, 9 for a rotation) of object i, converted to double and back. On CUDA a
/// transfer each.
/// @throw Error when i or k is out of range, or nothing is stored of the field; putdata also for an element of a
/// rotation stored as a quaternion, for a value that is no index where one is stored, and in checked builds for one
/// that the format cannot hold
[[nodiscard]] double getdata(const UntypedArray& array, index_t i, int k);
void putdata(const UntypedArray& array, index_t i, int k, double value);

/// Waits until all work in `stream` is done. Nothing to do without CUDA or a device.
/// @throw Error with CUDA's message when the work failed, and when the stream is being captured
void synchronize(Stream stream = nullptr);

/// Whether this build has CUDA and the machine a usable device; found out once.
[[nodiscard]] bool cuda_available();

namespace detail {

/// @throw Error naming `what` where the stream is being captured, or, of the default stream, one that waits for it
void refuse_capture(Stream stream, const char* what);

/// Before the host works on memory of this space: waits for the stream where the device may be at it.
void wait_for_host_work(SpaceKind space, Stream stream = nullptr);

}  // namespace detail

}  // namespace physgen
