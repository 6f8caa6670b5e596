// The law of addresses over an array without its types, prepared for loops over its objects.
#pragma once

#include <physgen/arrays/untyped_array.h>
#include <physgen/layout/address.h>

namespace physgen::detail {

/// The places of the objects of an array, or of a part of one. Its pitch is a power of two or the whole array, so that
/// a shift finds the tile; of a whole array it always finds tile 0.
struct Addressing {
  std::byte* base;
  index_t pitch;
  int shift;
  int record_bytes;
  index_t first;  ///< the number of the object that lies at its beginning

  explicit Addressing(const UntypedArray& array, index_t first_object = 0)
      : base(array.base), pitch(array.pitch), shift(63), record_bytes(array.record_bytes), first(first_object) {
    if (array.pitch < array.padded || array.pitch == 1) {
      for (shift = 0; (index_t{1} << shift) < array.pitch;) ++shift;
    }
  }
  /// The tile of object i, and its lane there.
  [[nodiscard]] PHYSGEN_FUNCTION index_t tile(index_t i) const { return (i - first) >> shift; }
  [[nodiscard]] PHYSGEN_FUNCTION index_t lane(index_t i) const { return i - first - (tile(i) << shift); }

  [[nodiscard]] PHYSGEN_FUNCTION std::byte* address(index_t i, int offset, int size) const {
    // law::element(), but pitch before record_bytes: their product, kept for all elements, would cost a kernel
    // registers.
    return base + law::tile_begin(tile(i) * pitch, record_bytes) + law::channel_begin(offset, pitch) +
           law::lane_begin(lane(i), size);
  }
  /// The beginning of the tile of object i.
  [[nodiscard]] PHYSGEN_FUNCTION std::byte* tile_of(index_t i) const {
    return base + law::tile_begin(tile(i), law::tile_bytes(pitch, record_bytes));
  }
  /// Whether whole records follow each other.
  [[nodiscard]] PHYSGEN_FUNCTION bool records() const { return pitch == 1; }
  /// Record i. @pre records()
  [[nodiscard]] PHYSGEN_FUNCTION std::byte* record(index_t i) const {
    return base + law::tile_begin(i - first, record_bytes);
  }
};

}  // namespace physgen::detail
