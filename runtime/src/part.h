// Parts of arrays: some objects of an array, in the same form, in memory of their own.
#pragma once

#include <physgen/layout/pitch.h>
#include <physgen/storage.h>

namespace physgen::detail {

/// The form of an array of `objects` objects that stores the records of `like`, with no memory yet.
[[nodiscard]] inline Storage part_of(const Storage& like, index_t objects, SpaceKind space) {
  Storage part = like;
  part.base = nullptr;
  part.size = objects;
  const bool many_tiles = like.pitch < like.padded;
  // An array of one short tile may be tiled or not: its part is as long, and the same whichever it is.
  constexpr index_t longest_tile = 1024;
  if (!many_tiles && like.padded <= longest_tile) {
    part.padded = like.padded;
  } else {
    part.pitch = many_tiles ? like.pitch : align_up(objects, padding_objects);
    part.padded = align_up(objects, many_tiles && like.pitch > padding_objects ? like.pitch : padding_objects);
  }
  part.space = space;
  return part;
}

/// Bytes of a record that its fields fill.
[[nodiscard]] inline int stored_bytes(const Storage& array) {
  int bytes = 0;
  for (const FieldInfo& field : array.fields) bytes += field.count * element_bytes(field.type);
  return bytes;
}

/// Objects that pass through a part at a time: about 8 MiB, whole tiles of every layout.
[[nodiscard]] inline index_t chunk_objects(const Storage& array) {
  constexpr index_t bytes = 8 << 20, tiles = 1024;
  return align_up(bytes / (array.record_bytes > 0 ? array.record_bytes : 1) + 1, tiles);
}

}  // namespace physgen::detail
