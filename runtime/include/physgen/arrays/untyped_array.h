// An array without its types: base, counts, pitch, record and fields as data. Conversions between layouts, precisions
// and spaces are written once over it, not once per pair of types.
#pragma once

#include <physgen/fields/object_info.h>
#include <physgen/layout/address.h>
#include <physgen/memory/space.h>

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
  /// The address of an element of object i that has `size` bytes and lies `offset` bytes into the record.
  [[nodiscard]] std::byte* address(index_t i, index_t offset, index_t size) const {
    return law::element(base, AnyPitch{pitch}, record_bytes, i, offset, size);
  }
};

}  // namespace physgen
