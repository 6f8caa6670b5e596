// The upper half of an IEEE float: 8 significant bits and the whole range of float.
#pragma once

#include <physgen/element_type.h>
#include <physgen/format/rounding.h>

namespace physgen::format {

namespace detail {

[[nodiscard]] PHYSGEN_FUNCTION inline float bfloat16_to_float(std::uint16_t bits) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(bits) << 16);
}

/// The nearest one, ties to even.
[[nodiscard]] PHYSGEN_FUNCTION inline std::uint16_t float_to_bfloat16(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  if ((bits & 0x7fffffffU) > 0x7f800000U) return static_cast<std::uint16_t>(bits >> 16 | 0x40U);  // NaN stays NaN
  return static_cast<std::uint16_t>((bits + 0x7fffU + (bits >> 16 & 1U)) >> 16);
}

}  // namespace detail

/// bfloat16: relative error <= 2^-8 (0.4 %) for magnitudes from 1.2e-38 to 3.4e38.
struct Bfloat16 {
  using Library = Bfloat16;
  static constexpr const char* name = "bfloat16";
  template <class Real>
  using Stored = std::uint16_t;
  template <class Real>
  static constexpr ElementType type = ElementType::bfloat16;
  static constexpr double scale = 1, centre = 0;

  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static Real decode(std::uint16_t stored) {
    return static_cast<Real>(detail::bfloat16_to_float(stored));
  }
  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static std::uint16_t encode(Real value) {
    return detail::float_to_bfloat16(detail::to_odd(value));
  }
};

}  // namespace physgen::format
