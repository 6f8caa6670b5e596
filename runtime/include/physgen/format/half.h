// IEEE half precision: 11 significant bits, magnitudes from 6e-5 (6e-8 with fewer bits) to 65504, times a power of two.
#pragma once

#include <physgen/detail/half_bits.h>
#include <physgen/detail/rounding.h>
#include <physgen/format/element_type.h>

namespace physgen::format {

/// Half precision of value * 2^-kExponent: relative error <= 2^-11 from 6.1e-5 to 65504, times 2^kExponent. Larger
/// values become infinite; smaller ones lose bits, down to 6e-8 times 2^kExponent.
template <int kExponent = 0>
struct Half {
  static_assert(kExponent >= -100 && kExponent <= 100, "a half is scaled by 2^-100 to 2^100");
  using Library = Half;
  static constexpr const char* name = "half";
  template <class Real>
  using Stored = std::uint16_t;
  template <class Real>
  static constexpr ElementType type = ElementType::half;
  static constexpr double scale = detail::power_of_two(kExponent), centre = 0;

  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static Real decode(std::uint16_t stored) {
    const auto value = static_cast<Real>(detail::half_to_float(stored));
    return kExponent == 0 ? value : value * static_cast<Real>(scale);
  }
  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static std::uint16_t encode(Real value) {
    const Real scaled = kExponent == 0 ? value : value * static_cast<Real>(1 / scale);
    return detail::float_to_half(detail::to_odd(scaled));
  }
};

}  // namespace physgen::format
