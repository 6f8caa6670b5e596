// Parts of arrays: some objects of an array, in the same form, in memory of their own.
#pragma once

#include <physgen/arrays/untyped_array.h>
#include <physgen/layout/pitch.h>

namespace physgen::detail {

/// The form of an array of `objects` objects that stores the records of `like`, with no memory yet.
[[nodiscard]] inline UntypedArray part_of(const UntypedArray& like, index_t objects, SpaceKind space) {
  UntypedArray part = like;
  part.base = nullptr;
  part.size = objects;
  const bool many_tiles = like.pitch < like.padded;
  // An array of one tile that a part of all its objects may hold: that is as long, and moves in one run.
  if (!many_tiles && like.padded <= align_up(objects, padding_objects)) {
    part.padded = like.padded;
  } else {
    part.pitch = many_tiles ? like.pitch : align_up(objects, padding_objects);
    part.padded = align_up(objects, many_tiles && like.pitch > padding_objects ? like.pitch : padding_objects);
  }
  part.space = space;
  return part;
}

/// Bytes of a record that its fields fill.
[[nodiscard]] inline int stored_bytes(const UntypedArray& array) {
  int bytes = 0;
  for (const FieldInfo& field : array.fields) bytes += field.count * element_bytes(field.type);
  return bytes;
}

}  // namespace physgen::detail
