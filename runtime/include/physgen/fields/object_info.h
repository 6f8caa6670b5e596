// The fields of an object type as data, which generated code gives the runtime beside the accessors.
#pragma once

#include <physgen/detail/own_codec.h>
#include <physgen/fields/shape.h>
#include <physgen/format.h>

#include <array>
#include <string_view>

namespace physgen {

/// One field of an object type: `count` stored elements of one type that follow each other from byte `offset` of the
/// record on. An element is centre + scale * what is stored, or what the functions of its own format say.
struct FieldInfo {
  std::string_view name;  ///< "svd.U" for a field of a nested object
  std::string_view unit;  ///< empty: none stated
  ElementType type;       ///< none: the field takes no bytes, and its elements cannot be read
  int offset;             ///< [bytes]
  int count;              ///< stored elements, 4 for each rotation that is a quaternion; those that code sees, of none
  double initial;         ///< value of every element of a new object, but of rotations, which begin as the identity
  double scale;
  double centre;
  bool rotation;                  ///< one or an array of them
  bool quaternion;                ///< rotations, stored as w, x, y, z
  const OwnCodec* own = nullptr;  ///< where the format is not the library's
  bool pruned = false;            ///< of type none, and copies to the array leave it out
  bool in_double = false;         ///< kernels compute with it in double, however it is stored
  std::string_view doc = {};      ///< what the schema says of it; empty: nothing

  /// Elements that code sees: 9 for a rotation, however it is stored.
  [[nodiscard]] PHYSGEN_FUNCTION constexpr int visible_count() const { return quaternion ? count / 4 * 9 : count; }
  [[nodiscard]] PHYSGEN_FUNCTION constexpr bool is_stored() const { return type != ElementType::none; }
};

/// Elements of a field of this shape and format that are stored.
template <class Shape, class Format>
inline constexpr int stored_count = format::is_quaternion<Format> ? 4 : Shape::count;

/// @tparam T the type computed with
/// @param entries of a fixed array; 1 for others
template <class Shape, class Format, class T>
[[nodiscard]] constexpr FieldInfo field_info(std::string_view name, std::string_view unit, int offset, int entries,
                                             double initial) {
  using Element = format::ElementFormat<Format>;
  return {name,
          unit,
          Element::template type<T>,
          offset,
          entries * stored_count<Shape, Format>,
          initial,
          Element::scale,
          Element::centre,
          std::is_same_v<Shape, shape::Rotation>,
          format::is_quaternion<Format>,
          detail::own_codec<Element, T>(),
          format::is_pruned<Element>,
          std::is_same_v<T, double>};
}

/// Whether something is stored of every field.
template <std::size_t N>
[[nodiscard]] constexpr bool all_stored(const std::array<FieldInfo, N>& fields) {
  for (const FieldInfo& field : fields)
    if (!field.is_stored()) return false;
  return true;
}

/// Number of elements over all fields, as code sees them.
template <std::size_t N>
[[nodiscard]] constexpr int element_count(const std::array<FieldInfo, N>& fields) {
  int count = 0;
  for (const FieldInfo& field : fields) count += field.visible_count();
  return count;
}

}  // namespace physgen
