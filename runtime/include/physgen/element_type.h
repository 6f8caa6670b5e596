// The types that single elements have in memory, as values and as C++ types.
#pragma once

#include <physgen/config.h>

#include <type_traits>

namespace physgen {

/// The stored type of an element. The 16-bit ones are bit patterns; their formats (format.h) say what they stand for.
enum class ElementType : std::uint8_t { float32, float64, int32, half, bfloat16, snorm16 };

/// Bytes of one element of this type; also its alignment.
[[nodiscard]] PHYSGEN_FUNCTION constexpr int element_bytes(ElementType type) {
  switch (type) {
    case ElementType::float64:
      return 8;
    case ElementType::float32:
    case ElementType::int32:
      return 4;
    case ElementType::half:
    case ElementType::bfloat16:
    case ElementType::snorm16:
      break;
  }
  return 2;
}

/// Largest relative error of an ordinary value in this type; 0 for integers and for equal steps, whose error is
/// absolute.
[[nodiscard]] PHYSGEN_FUNCTION constexpr double relative_error(ElementType type) {
  switch (type) {
    case ElementType::float64:
      return 0x1p-53;
    case ElementType::float32:
      return 0x1p-24;
    case ElementType::half:
      return 0x1p-11;
    case ElementType::bfloat16:
      return 0x1p-8;
    case ElementType::int32:
    case ElementType::snorm16:
      break;
  }
  return 0;
}

/// The ElementType of a C++ type.
template <class T>
  requires(std::is_same_v<T, float> || std::is_same_v<T, double> || std::is_same_v<T, std::int32_t>)
inline constexpr ElementType element_type = std::is_same_v<T, float>    ? ElementType::float32
                                            : std::is_same_v<T, double> ? ElementType::float64
                                                                        : ElementType::int32;

}  // namespace physgen
