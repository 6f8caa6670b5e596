// What topology changes do to one object, on host and device: its elements move as plain bytes, its indices change.
#pragma once

#include <cstring>
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

/// Copies kBytes bytes, aligned to as many, as one load and one store.
template <int kBytes>
PHYSGEN_FUNCTION inline void move_word(std::byte* to, const std::byte* from) {
  std::memcpy(__builtin_assume_aligned(to, kBytes), __builtin_assume_aligned(from, kBytes), kBytes);
}

/// Copies one element of object j of `from` to object i of `to`.
PHYSGEN_FUNCTION inline void move_element(const Addressing& to, index_t i, const Addressing& from, index_t j,
                                          int offset, int bytes) {
  std::byte* target = to.address(i, offset, bytes);
  const std::byte* source = from.address(j, offset, bytes);
  if (bytes == 8) return move_word<8>(target, source);
  if (bytes == 4) return move_word<4>(target, source);
  move_word<2>(target, source);
}

/// Copies the elements of object j of `from` to object i of `to`.
PHYSGEN_FUNCTION inline void move_elements(const Addressing& to, index_t i, const Addressing& from, index_t j,
                                           const Elements& elements) {
  for (int k = 0; k < elements.count; ++k) {
    move_element(to, i, from, j, elements.offset + k * elements.bytes, elements.bytes);
  }
}

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

/// Element k of a field of indices.
PHYSGEN_FUNCTION inline std::int32_t& index_at(const Addressing& address, int offset, int k, index_t i) {
  constexpr int size = sizeof(std::int32_t);
  return *reinterpret_cast<std::int32_t*>(address.address(i, offset + k * size, size));
}

/// Whether every index of object i can be renumbered.
PHYSGEN_FUNCTION inline bool can_renumber(const Addressing& address, int offset, int count,
                                          const NewNumbers& renumbered, index_t i) {
  for (int k = 0; k < count; ++k) {
    if (!renumbered.has(index_at(address, offset, k, i))) return false;
  }
  return true;
}

/// Renumbers every index of object i. @pre can_renumber()
PHYSGEN_FUNCTION inline void renumber_object(const Addressing& address, int offset, int count,
                                             const NewNumbers& renumbered, index_t i) {
  for (int k = 0; k < count; ++k) {
    std::int32_t& index = index_at(address, offset, k, i);
    index = static_cast<std::int32_t>(renumbered.numbers[index]);
  }
}

}  // namespace physgen::detail
