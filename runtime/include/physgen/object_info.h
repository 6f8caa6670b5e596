// What generated code tells the runtime about an object type beyond its accessors: its fields as data.
#pragma once

#include <physgen/config.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <type_traits>

namespace physgen {

/// The stored type of an element.
enum class ElementType : std::uint8_t { float32, float64, int32 };

/// Bytes of one element of this type.
[[nodiscard]] PHYSGEN_FUNCTION constexpr int element_bytes(ElementType type) {
  return type == ElementType::float64 ? 8 : 4;
}

/// The ElementType of a C++ type.
template <class T>
  requires(std::is_same_v<T, float> || std::is_same_v<T, double> || std::is_same_v<T, std::int32_t>)
inline constexpr ElementType element_type = std::is_same_v<T, float>    ? ElementType::float32
                                            : std::is_same_v<T, double> ? ElementType::float64
                                                                        : ElementType::int32;

/// One field of an object type: `count` elements of one type that follow each other from byte `offset` of the record
/// on.
struct FieldInfo {
  std::string_view name;  ///< "svd.U" for a field of a nested object
  std::string_view unit;  ///< empty: none stated
  ElementType type;
  int offset;  ///< [bytes]
  int count;
  double initial;  ///< value of every element of a new object
};

/// Where element `k` (counted over all fields in order) lies in a record.
struct ElementInfo {
  ElementType type;
  int offset;  ///< [bytes]
};

/// Number of elements over all fields.
template <std::size_t N>
[[nodiscard]] constexpr int element_count(const std::array<FieldInfo, N>& fields) {
  int count = 0;
  for (const FieldInfo& field : fields) count += field.count;
  return count;
}

/// One of two numbers of bytes: of a record whose Real is float, and of one whose Real is double.
template <class Real>
[[nodiscard]] PHYSGEN_FUNCTION constexpr int by_precision(int with_float, int with_double) {
  return sizeof(Real) == sizeof(double) ? with_double : with_float;
}

/// Whether the record of `Object` has these bytes and this alignment, all its elements lie inside it and are aligned to
/// their size, and no two of them share a byte. Generated code proves this of every record when it is compiled.
template <class Object, class Real>
[[nodiscard]] constexpr bool is_sound_record(int bytes, int alignment) {
  using Record = typename Object::template Record<Real>;
  if (Record::bytes != bytes || Record::alignment != alignment) return false;
  auto fields = Object::template fields<Real>;
  std::sort(fields.begin(), fields.end(), [](const FieldInfo& a, const FieldInfo& b) { return a.offset < b.offset; });
  int end = 0;  // of the fields so far
  for (const FieldInfo& field : fields) {
    const int size = element_bytes(field.type);
    if (field.offset < end || field.offset % size != 0 || alignment % size != 0) return false;
    end = field.offset + field.count * size;
  }
  return end <= bytes;
}

}  // namespace physgen
