// The law of addresses, which cursors, conversions, copies and drawings of layouts call. One expression of
// detail/cursor.h writes its last two terms out, for the sake of nvcc.
//
// An array is cut into tiles of `pitch` objects, and a tile into one channel for each element of a record: the same
// element of all objects of the tile, side by side. Here with a pitch of 4 and records of two elements, x and y:
//
//   array     | tile 0                    | tile 1                    | ...
//   tile      | channel x   | channel y   | channel x   | channel y   |
//   lanes     | 0  1  2  3  | 0  1  2  3  | 0  1  2  3  | 0  1  2  3  |
//   objects   | 0  1  2  3  | 0  1  2  3  | 4  5  6  7  | 4  5  6  7  |
//
// A record takes `record_bytes` bytes, and so a tile takes pitch * record_bytes. An element of `size` bytes that
// lies `offset` bytes into the record has its channel at offset * pitch of the tile, and object i has lane i % pitch:
//
//   address(i, offset) = base + (i / pitch) * pitch * record_bytes + offset * pitch + (i % pitch) * size
//
// A layout is no more than its pitch: 1 is an array of structs, W an array of structs of W-wide arrays, the padded
// number of objects a struct of arrays.
#pragma once

#include <physgen/layout/pitch.h>

namespace physgen::law {

/// The size of a tile [bytes].
[[nodiscard]] PHYSGEN_FUNCTION constexpr index_t tile_bytes(index_t pitch, index_t record_bytes) {
  return pitch * record_bytes;
}

/// The beginning of a tile in its array [bytes].
/// @param bytes of each tile: tile_bytes(). (Made of pitch and record here, it would cost nvcc an instruction.)
[[nodiscard]] PHYSGEN_FUNCTION constexpr index_t tile_begin(index_t tile, index_t bytes) { return tile * bytes; }

/// The beginning, in its tile, of the channel of an element at `offset` of the record, in the unit of `offset`; element
/// k after another one lies channel_begin(k, pitch) elements after it.
[[nodiscard]] PHYSGEN_FUNCTION constexpr index_t channel_begin(index_t offset, index_t pitch) { return offset * pitch; }

/// The beginning, in its channel, of the element of the object at `lane` [bytes].
[[nodiscard]] PHYSGEN_FUNCTION constexpr index_t lane_begin(index_t lane, index_t size) { return lane * size; }

/// The law: the address of an element of object i.
/// @param base the array's first byte; or the number of a byte, 0 for the distance from the beginning of the array
/// @param pitch StaticPitch, WholePitch or another type with their functions
/// @param offset of the element in the record [bytes]
/// @param size of the element [bytes]
template <class Start, class Pitch>
[[nodiscard]] PHYSGEN_FUNCTION constexpr Start element(Start base, const Pitch& pitch, index_t record_bytes, index_t i,
                                                       index_t offset, index_t size) {
  return base + tile_begin(pitch.tile(i), tile_bytes(pitch.value(), record_bytes)) +
         channel_begin(offset, pitch.value()) + lane_begin(pitch.lane(i), size);
}

}  // namespace physgen::law
