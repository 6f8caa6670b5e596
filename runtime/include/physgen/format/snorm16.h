// Signed normalised 16-bit integers: 65535 equal steps over a stated range.
#pragma once

#include <physgen/element_type.h>

#include <cmath>
#include <limits>

namespace physgen::format {

namespace detail {

inline constexpr int snorm16_steps = facts(ElementType::snorm16).steps;
inline constexpr std::int16_t snorm16_nan = -32768;  ///< stands for NaN

/// Whether steps over centre - scale to centre + scale are computed in Real without its running out of range; if not,
/// they are computed in double, and by division.
template <class Real>
[[nodiscard]] PHYSGEN_FUNCTION constexpr bool snorm16_is_ordinary(double scale, double centre) {
  constexpr double low = sizeof(Real) == 4 ? 1e-30 : 1e-290, high = sizeof(Real) == 4 ? 1e38 : 1e307;
  return scale >= low && scale + (centre < 0 ? -centre : centre) <= high;
}

/// @return centre - scale to centre + scale, or NaN
template <class Real>
[[nodiscard]] PHYSGEN_FUNCTION inline Real snorm16_to_real(std::int16_t stored, Real scale, Real centre) {
  const Real value = std::fma(static_cast<Real>(stored), scale * (Real(1) / snorm16_steps), centre);
  return stored == snorm16_nan ? std::numeric_limits<Real>::quiet_NaN() : value;
}
/// For any range.
template <class Real>
[[nodiscard]] PHYSGEN_FUNCTION inline Real snorm16_to_real_exactly(std::int16_t stored, double scale, double centre) {
  const double value = std::fma(static_cast<double>(stored) / snorm16_steps, scale, centre);
  return stored == snorm16_nan ? std::numeric_limits<Real>::quiet_NaN() : static_cast<Real>(value);
}

template <class Real>
[[nodiscard]] PHYSGEN_FUNCTION inline std::int16_t nearest_step(Real steps) {
  const Real limit = Real(snorm16_steps);
  const Real held = steps < -limit ? -limit : steps > limit ? limit : steps;
  return held != held ? snorm16_nan : static_cast<std::int16_t>(std::rint(held));
}

/// The nearest step; the end of the range beyond it.
template <class Real>
[[nodiscard]] PHYSGEN_FUNCTION inline std::int16_t real_to_snorm16(Real value, Real scale, Real centre) {
  return nearest_step((value - centre) * (snorm16_steps / scale));
}
/// For any range.
template <class Real>
[[nodiscard]] PHYSGEN_FUNCTION inline std::int16_t real_to_snorm16_exactly(Real value, double scale, double centre) {
  return nearest_step((static_cast<double>(value) - centre) / scale * snorm16_steps);
}

}  // namespace detail

/// The numbers from low to high.
struct Interval {
  double low, high;
};

/// kRange.low to kRange.high in equal steps: absolute error <= (high - low) / 131068, and the rounding of Real at the
/// larger end. Values beyond become the end of the range; NaN stays NaN.
template <Interval kRange>
struct Snorm16 {
  static_assert(kRange.low < kRange.high, "the range of a Snorm16 goes from a number to a larger one");
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
