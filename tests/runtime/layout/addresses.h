// Addresses of elements in a layout, for records of three floats, a double behind them, or any other.
#pragma once

#include <physgen/layout.h>
#include <physgen/layout/address.h>

namespace physgen::test {

/// Bytes from the first byte of an array to an element.
/// @param objects that the array has
/// @param bytes, alignment of a record without padding
/// @param offset, size of the element in the record [bytes]
template <class Layout>
constexpr index_t address_in(index_t objects, int bytes, int alignment, index_t i, index_t offset, index_t size) {
  const typename Layout::Pitch pitch(Layout::pitch(objects));
  return law::tile_begin(pitch.tile(i), law::tile_bytes(pitch.value(), Layout::record_bytes(bytes, alignment))) +
         law::channel_begin(offset, pitch.value()) + law::lane_begin(pitch.lane(i), size);
}

}  // namespace physgen::test
