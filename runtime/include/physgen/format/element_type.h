// The types that single elements have in memory, as values and as C++ types.
#pragma once

#include <physgen/config.h>

#include <type_traits>

namespace physgen {

/// The stored type of an element. The 16-bit ones are bit patterns; their formats (format.h) say what they stand for.
/// none: nothing is stored.
enum class ElementType : std::uint8_t {
  float32,
  float64,
  int32,
  int64,
  uint64,
  boolean,
  half,
  bfloat16,
  snorm16,
  none
};

/// Facts that hold for all elements of a stored type.
struct ElementTypeFacts {
  int bytes;               ///< also its alignment; 0 of none
  double relative_error;   ///< largest of an ordinary value; 0 for integers and for equal steps
  int steps;               ///< to either side of the centre, where they are equal and errors absolute; else 0
  std::uint64_t no_value;  ///< bits_of_no_value()
};
[[nodiscard]] PHYSGEN_FUNCTION constexpr ElementTypeFacts facts(ElementType type) {
  switch (type) {
    case ElementType::float32:
      return {4, 0x1p-24, 0, 0x7fa00000};
    case ElementType::float64:
      return {8, 0x1p-53, 0, 0x7ff4000000000000};
    case ElementType::int32:
      return {4, 0, 0, 0x80000000};
    case ElementType::int64:
      return {8, 0, 0, 0x8000000000000000};
    case ElementType::uint64:
      return {8, 0, 0, 0xffffffffffffffff};
    case ElementType::boolean:
      return {1, 0, 0, 1};
    case ElementType::half:
      return {2, 0x1p-11, 0, 0x7d00};
    case ElementType::bfloat16:
      return {2, 0x1p-8, 0, 0x7fa0};
    case ElementType::none:
      return {0, 0, 0, 0};
    case ElementType::snorm16:
      break;
  }
  return {2, 0, 32767, 0x8000};
}

[[nodiscard]] PHYSGEN_FUNCTION constexpr int element_bytes(ElementType type) { return facts(type).bytes; }
[[nodiscard]] PHYSGEN_FUNCTION constexpr double relative_error(ElementType type) { return facts(type).relative_error; }

/// The bits of an element that has no value yet: a signalling NaN; of steps the pattern that stands for NaN; of
/// integers the lowest, which is not an index, but of unsigned ones the largest; of bool `true`, since others are no
/// bool.
[[nodiscard]] PHYSGEN_FUNCTION constexpr std::uint64_t bits_of_no_value(ElementType type) {
  return facts(type).no_value;
}

/// Whether elements are integers or bool: they are stored as they are, and copied with all their bits.
[[nodiscard]] PHYSGEN_FUNCTION constexpr bool is_whole(ElementType type) {
  return type == ElementType::int32 || type == ElementType::int64 || type == ElementType::uint64 ||
         type == ElementType::boolean;
}

namespace detail {

template <class T>
[[nodiscard]] constexpr ElementType element_type_of() {
  if (std::is_same_v<T, float>) return ElementType::float32;
  if (std::is_same_v<T, double>) return ElementType::float64;
  if (std::is_same_v<T, std::int32_t>) return ElementType::int32;
  if (std::is_same_v<T, std::int64_t>) return ElementType::int64;
  if (std::is_same_v<T, std::uint64_t>) return ElementType::uint64;
  return std::is_same_v<T, bool> ? ElementType::boolean : ElementType::none;
}

}  // namespace detail

/// The ElementType of a C++ type.
template <class T>
  requires(detail::element_type_of<T>() != ElementType::none)
inline constexpr ElementType element_type = detail::element_type_of<T>();

}  // namespace physgen
