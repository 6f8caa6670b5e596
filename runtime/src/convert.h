// A conversion of objects between two arrays as data: which elements move where, on host and device.
#pragma once

#include <physgen/detail/count_losses.h>

#include <bit>
#include <cmath>
#include <vector>

#include "addressing.h"
#include "element_codec.h"

namespace physgen::detail {

/// One element of every object.
struct ElementMove {
  int to_offset;
  int from_offset;
  FieldFormat to;
  FieldFormat from;
};

/// One rotation of every object, a matrix on one side and a quaternion on the other.
struct RotationMove {
  ElementMove first;  ///< of its elements
  bool to_quaternion;

  template <class S>
  PHYSGEN_FUNCTION Eigen::Matrix<S, 3, 3> read(const Addressing& from, index_t i) const {
    const int size = element_bytes(first.from.type);
    return decode_rotation<S>(first.from, !to_quaternion,
                              [&](int k) { return from.address(i, first.from_offset + k * size, size); });
  }
  PHYSGEN_FUNCTION void apply(const Addressing& to, const Addressing& from, index_t i) const {
    const int size = element_bytes(first.to.type);
    const auto at = [&](int k) { return to.address(i, first.to_offset + k * size, size); };
    if (converts_in_double(first.to, first.from)) {
      encode_rotation<double>(first.to, to_quaternion, at, read<double>(from, i));
    } else {
      encode_rotation<float>(first.to, to_quaternion, at, read<float>(from, i));
    }
  }
};

/// All moves of a conversion. Fields of which one side stores nothing are left out.
struct Conversion {
  std::vector<ElementMove> elements;
  std::vector<RotationMove> rotations;
  std::vector<RotationMove> kept_quaternions;  ///< quaternions on both sides; `elements` has their components

  Conversion(const UntypedArray& to, const UntypedArray& from) {
    for (std::size_t f = 0; f < to.fields.size(); ++f) {
      const FieldInfo &a = to.fields[f], &b = from.fields[f];
      if (!a.is_stored() || !b.is_stored()) continue;
      const int to_size = element_bytes(a.type), from_size = element_bytes(b.type);
      const ElementMove first{a.offset, b.offset, FieldFormat(a), FieldFormat(b)};
      const auto at = [&](int to_element, int from_element) {
        ElementMove move = first;
        move.to_offset += to_element * to_size;
        move.from_offset += from_element * from_size;
        return move;
      };
      if (a.quaternion == b.quaternion) {
        for (int k = 0; k < a.count; ++k) elements.push_back(at(k, k));
        for (int k = 0; a.quaternion && k < a.count; k += 4) kept_quaternions.push_back({at(k, k), false});
      } else {
        for (int r = 0; r < a.visible_count() / 9; ++r) {
          rotations.push_back({at(r * (a.quaternion ? 4 : 9), r * (b.quaternion ? 4 : 9)), a.quaternion});
        }
      }
    }
  }
};

/// The initial value of one field, as it is stored. @pre the field is stored
struct Fill {
  int offset;
  int count;
  int size;
  bool rotation;
  bool quaternion;
  std::uint64_t value = 0;  // of all elements; of a rotation, of those that are 0
  std::uint64_t one = 0;    // of the others

  explicit Fill(const FieldInfo& field)
      : offset(field.offset),
        count(field.count),
        size(element_bytes(field.type)),
        rotation(field.rotation),
        quaternion(field.quaternion) {
    const auto stored = [format = FieldFormat(field)](double number) {
      alignas(8) std::byte bytes[8] = {};
      encode(bytes, format, number);
      return std::bit_cast<std::uint64_t>(bytes);
    };
    value = stored(rotation ? 0.0 : field.initial);
    if (rotation) one = stored(1.0);
  }
  /// Whether it would write what cleared memory holds.
  [[nodiscard]] bool is_zero() const { return value == 0 && one == 0; }
  /// Element k, as it is stored.
  [[nodiscard]] PHYSGEN_FUNCTION std::uint64_t bits(int k) const {
    return rotation && (quaternion ? k % 4 == 0 : k % 9 % 4 == 0) ? one : value;  // w, or the diagonal
  }
  PHYSGEN_FUNCTION void apply(const Addressing& array, index_t i) const {
    for (int k = 0; k < count; ++k) {
      const std::uint64_t element = bits(k);
      move_bits(array.address(i, offset + k * size, size), reinterpret_cast<const std::byte*>(&element), size);
    }
  }
};

/// The first field that changes between the two arrays by functions of a format of a program's own, which only the host
/// has; else null.
[[nodiscard]] inline const FieldInfo* changed_by_own_functions(const UntypedArray& to, const UntypedArray& from) {
  for (std::size_t f = 0; f < to.fields.size(); ++f) {
    const FieldInfo &a = to.fields[f], &b = from.fields[f];
    if ((a.own == nullptr && b.own == nullptr) || !a.is_stored() || !b.is_stored()) continue;
    if (a.quaternion != b.quaternion || !(FieldFormat(a) == FieldFormat(b))) return &a;
  }
  return nullptr;
}

/// Counts what `move` could not hold of object i, computed in S as convert_element() does.
template <class S>
PHYSGEN_FUNCTION inline void count_element_in(Losses& losses, const ElementMove& move, const Addressing& from,
                                              index_t i) {
  alignas(8) std::byte stored[8];
  const S value = decode<S>(from.address(i, move.from_offset, element_bytes(move.from.type)), move.from);
  encode<S>(stored, move.to, value);
  count_loss(losses, move.to.type, move.to.scale, static_cast<double>(value),
             static_cast<double>(decode<S>(stored, move.to)), i, move.to_offset);
}
PHYSGEN_FUNCTION inline void count_element(Losses& losses, const ElementMove& move, const Addressing& from, index_t i) {
  if (is_whole(move.to.type)) return;
  if (move.to.own != nullptr && move.to == move.from) return;  // it moves as it is
  if (converts_in_double(move.to, move.from)) return count_element_in<double>(losses, move, from, i);
  count_element_in<float>(losses, move, from, i);
}
PHYSGEN_FUNCTION inline void count_rotation(Losses& losses, const RotationMove& move, const Addressing& from,
                                            index_t i) {
  double deviation = 0;
  if (move.to_quaternion) {
    deviation = rotation_deviation(move.read<double>(from, i));
  } else {
    const int size = element_bytes(move.first.from.type);
    double square = 0;
    for (int k = 0; k < 4; ++k) {
      const double q = decode<double>(from.address(i, move.first.from_offset + k * size, size), move.first.from);
      square += q * q;
    }
    deviation = std::abs(square - 1);
  }
  count_deviation(losses, deviation, i, move.first.to_offset);
}

}  // namespace physgen::detail
