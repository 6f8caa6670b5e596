// The upper half of an IEEE float: 8 significant bits and the whole range of float.
#pragma once

#include <physgen/detail/bfloat16_bits.h>
#include <physgen/detail/rounding.h>
#include <physgen/format/element_type.h>

namespace physgen::format {

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
