// A field of some objects, and the bytes of a message that hold it.
#pragma once

#include <physgen/distributed/halo_plan.h>

#include <algorithm>
#include <cstring>

#include "../addressing.h"

namespace physgen::detail {

/// Whole elements, and whole fields of small objects, are moved without a call.
inline void move_bytes(std::byte* to, const std::byte* from, std::size_t bytes) {
  switch (bytes) {
    case 2:
      return void(std::memcpy(to, from, 2));
    case 4:
      return void(std::memcpy(to, from, 4));
    case 8:
      return void(std::memcpy(to, from, 8));
    case 12:
      return void(std::memcpy(to, from, 12));
    case 24:
      return void(std::memcpy(to, from, 24));
    default:
      std::memcpy(to, from, bytes);
  }
}

/// Goes through the pieces of a field in an array and in a message. Where the records of an array follow each other,
/// the message has the field object by object, and else element by element. Both ranks have arrays of the same layout;
/// an array of one object may be either, and the bytes of one object are the same.
/// @param place in the message: an address, or a number of bytes
/// @param move move(address in the array, place, bytes)
/// @return the place behind
template <class Place, class Move>
Place for_each_piece(const UntypedArray& memory, const FieldInfo& info, const ObjectRuns& objects, Place place,
                     const Move& move) {
  if (!info.is_stored()) return place;
  const Addressing array(memory);
  const int size = element_bytes(info.type);
  if (array.records()) {
    const index_t of_field = index_t{info.count} * size;
    const bool is_all = of_field == memory.record_bytes;
    for (const ObjectRuns::Run& run : objects.runs) {
      const index_t step = is_all ? run.count : 1;
      for (index_t i = run.first; i < run.first + run.count; i += step, place += of_field * step) {
        move(array.record(i) + info.offset, place, static_cast<std::size_t>(of_field * step));
      }
    }
    return place;
  }
  for (int k = 0; k < info.count; ++k) {
    for (const ObjectRuns::Run& run : objects.runs) {
      if (run.count == 1) {  // as most are in a mesh without order
        move(array.address(run.first, info.offset + k * size, size), place, static_cast<std::size_t>(size));
        place += size;
        continue;
      }
      const index_t end = run.first + run.count;
      for (index_t i = run.first; i < end;) {  // up to the end of the tile
        const index_t lanes = std::min(end - i, memory.pitch - array.lane(i));
        move(array.address(i, info.offset + k * size, size), place, static_cast<std::size_t>(lanes * size));
        place += lanes * size;
        i += lanes;
      }
    }
  }
  return place;
}

/// Copies a field of some objects into a message. @return the place behind it in the message
inline std::byte* pack(const UntypedArray& memory, const FieldInfo& info, const ObjectRuns& objects, std::byte* to) {
  return for_each_piece(memory, info, objects, to,
                        [](const std::byte* at, std::byte* in, std::size_t bytes) { move_bytes(in, at, bytes); });
}
/// Copies a field of some objects out of a message. @return the place behind it in the message
inline const std::byte* unpack(const UntypedArray& memory, const FieldInfo& info, const ObjectRuns& objects,
                               const std::byte* from) {
  return for_each_piece(memory, info, objects, from,
                        [](std::byte* at, const std::byte* in, std::size_t bytes) { move_bytes(at, in, bytes); });
}

}  // namespace physgen::detail
