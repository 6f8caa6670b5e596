// Changes of topology move the elements of an object as plain bytes and renumber its indices, on host and device.
#pragma once

#include <limits>

#include "convert.h"

namespace physgen::detail {

/// A list of object numbers, or all numbers in their order.
struct Picked {
  const index_t* numbers;  ///< null: all

  [[nodiscard]] PHYSGEN_FUNCTION index_t operator[](index_t i) const { return numbers != nullptr ? numbers[i] : i; }
};

/// Elements of one size that follow each other in a record, whatever their type.
struct Elements {
  int offset;  ///< [bytes]
  int bytes;   ///< of one
  int count;

  explicit Elements(const FieldInfo& field)
      : offset(field.offset), bytes(element_bytes(field.type)), count(field.count) {}
  Elements() = default;
};

/// Copies the elements of object j of `from` to object i of `to`.
PHYSGEN_FUNCTION inline void move_elements(const Addressing& to, index_t i, const Addressing& from, index_t j,
                                           const Elements& elements) {
  for (int k = 0; k < elements.count; ++k) {
    const int offset = elements.offset + k * elements.bytes;
    move_bits(to.address(i, offset, elements.bytes), from.address(j, offset, elements.bytes), elements.bytes);
  }
}

/// The indices of a field.
struct Indices {
  Addressing addresses;
  int offset;  ///< of the field [bytes]
  int count;   ///< of an object

  Indices(const UntypedArray& array, const FieldInfo& field)
      : addresses(array), offset(field.offset), count(field.count) {}
  /// Index k of object i.
  [[nodiscard]] PHYSGEN_FUNCTION std::int32_t& operator()(index_t i, int k) const {
    constexpr int size = sizeof(std::int32_t);
    return *reinterpret_cast<std::int32_t*>(addresses.address(i, offset + k * size, size));
  }
};

/// The new number of every object, as renumber() is given it.
struct NewNumbers {
  const index_t* numbers;
  index_t count;

  /// Whether `index` names an object that has a new number which an index can hold.
  [[nodiscard]] PHYSGEN_FUNCTION bool has(std::int32_t index) const {
    return index >= 0 && index < count && numbers[index] >= 0 &&
           numbers[index] <= std::numeric_limits<std::int32_t>::max();
  }
};

/// Renumbers a field of indices, object by object.
struct Renumbering {
  Indices index;
  NewNumbers renumbered;

  /// Whether every index of object i can be renumbered.
  [[nodiscard]] PHYSGEN_FUNCTION bool can_renumber(index_t i) const {
    for (int k = 0; k < index.count; ++k) {
      if (!renumbered.has(index(i, k))) return false;
    }
    return true;
  }
  /// @pre can_renumber(i)
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    for (int k = 0; k < index.count; ++k) index(i, k) = static_cast<std::int32_t>(renumbered.numbers[index(i, k)]);
  }
};

}  // namespace physgen::detail
