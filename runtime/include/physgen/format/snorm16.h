// Signed normalised 16-bit integers: 65535 equal steps over a stated range.
#pragma once

#include <physgen/detail/snorm16_steps.h>
#include <physgen/format/element_type.h>

#include <cmath>
#include <limits>

namespace physgen::format {

/// The numbers from low to high.
struct Interval {
  double low, high;
};

/// kRange.low to kRange.high in equal steps: absolute error <= (high - low) / 131068, and the rounding of Real at the
/// larger end. Values beyond become the end of the range; NaN stays NaN.
template <Interval kRange>
struct Snorm16 {
  static_assert(kRange.low < kRange.high, "Snorm16: range.low must be less than range.high");
  using Library = Snorm16;
  static constexpr const char* name = "snorm16";
  template <class Real>
  using Stored = std::int16_t;
  template <class Real>
  static constexpr ElementType type = ElementType::snorm16;
  static constexpr double scale = kRange.high / 2 - kRange.low / 2, centre = kRange.high / 2 + kRange.low / 2;

  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static Real decode(std::int16_t stored) {
    if constexpr (detail::snorm16_is_ordinary<Real>(scale, centre)) {
      return detail::snorm16_to_real<Real>(stored, Real(scale), Real(centre));
    } else {
      return detail::snorm16_to_real_exactly<Real>(stored, scale, centre);
    }
  }
  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static std::int16_t encode(Real value) {
    if constexpr (detail::snorm16_is_ordinary<Real>(scale, centre)) {
      return detail::real_to_snorm16<Real>(value, Real(scale), Real(centre));
    } else {
      return detail::real_to_snorm16_exactly<Real>(value, scale, centre);
    }
  }
};

}  // namespace physgen::format
