// Conversion of one object between two arrays, on host and device: the law of addresses with run-time values.
#pragma once

#include <physgen/storage.h>

namespace physgen::detail {

/// Addresses of a Storage with the pitch prepared for a shift and a mask; a whole-array pitch never leaves tile 0.
struct Addressing {
  std::byte* base;
  index_t pitch;
  int shift;
  int record_bytes;

  explicit Addressing(const Storage& storage)
      : base(storage.base), pitch(storage.pitch), shift(63), record_bytes(storage.record_bytes) {
    if (storage.pitch < storage.padded || storage.pitch == 1) {
      for (shift = 0; (index_t{1} << shift) < storage.pitch;) ++shift;
    }
  }
  [[nodiscard]] PHYSGEN_FUNCTION std::byte* address(index_t i, int offset, int size) const {
    const index_t tile = i >> shift;
    const index_t lane = i - (tile << shift);
    return base + tile * pitch * record_bytes + offset * pitch + lane * size;
  }
};

/// How one field is converted.
struct FieldConversion {
  int to_offset;
  int from_offset;
  ElementType to_type;
  ElementType from_type;
  int count;
};

PHYSGEN_FUNCTION inline void convert_element(std::byte* to, ElementType to_type, const std::byte* from,
                                             ElementType from_type) {
  if (to_type == ElementType::int32) {
    *reinterpret_cast<std::int32_t*>(to) = *reinterpret_cast<const std::int32_t*>(from);
  } else if (to_type == ElementType::float32) {
    *reinterpret_cast<float*>(to) = from_type == ElementType::float32
                                        ? *reinterpret_cast<const float*>(from)
                                        : static_cast<float>(*reinterpret_cast<const double*>(from));
  } else {
    *reinterpret_cast<double*>(to) = from_type == ElementType::float32
                                         ? static_cast<double>(*reinterpret_cast<const float*>(from))
                                         : *reinterpret_cast<const double*>(from);
  }
}

/// Converts one field of object i.
PHYSGEN_FUNCTION inline void convert_field(const Addressing& to, const Addressing& from, const FieldConversion& field,
                                           index_t i) {
  const int to_size = element_bytes(field.to_type);
  const int from_size = element_bytes(field.from_type);
  for (int k = 0; k < field.count; ++k) {
    convert_element(to.address(i, field.to_offset + k * to_size, to_size), field.to_type,
                    from.address(i, field.from_offset + k * from_size, from_size), field.from_type);
  }
}

/// Sets all elements of one field of object i to `value`.
PHYSGEN_FUNCTION inline void fill_field(const Addressing& address, int offset, ElementType type, int count,
                                        double value, index_t i) {
  const int size = element_bytes(type);
  for (int k = 0; k < count; ++k) {
    std::byte* element = address.address(i, offset + k * size, size);
    if (type == ElementType::int32) {
      *reinterpret_cast<std::int32_t*>(element) = static_cast<std::int32_t>(value);
    } else if (type == ElementType::float32) {
      *reinterpret_cast<float*>(element) = static_cast<float>(value);
    } else {
      *reinterpret_cast<double*>(element) = value;
    }
  }
}

}  // namespace physgen::detail
