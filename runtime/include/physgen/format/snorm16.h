// Signed normalised 16-bit integers: 65535 equal steps over a stated range.
#pragma once

#include <physgen/element_type.h>

#include <cmath>
#include <limits>

namespace physgen::format {

namespace detail {

inline constexpr int snorm16_steps = 32767;          ///< to either side of the centre
inline constexpr std::int16_t snorm16_nan = -32768;  ///< stands for NaN

/// @return centre - scale to centre + scale, or NaN
template <class Real>
[[nodiscard]] PHYSGEN_FUNCTION inline Real snorm16_to_real(std::int16_t stored, Real scale, Real centre) {
  const Real value = std::fma(static_cast<Real>(stored), scale * (Real(1) / snorm16_steps), centre);
  return stored == snorm16_nan ? std::numeric_limits<Real>::quiet_NaN() : value;
}

/// The nearest step; the end of the range beyond it.
template <class Real>
[[nodiscard]] PHYSGEN_FUNCTION inline std::int16_t real_to_snorm16(Real value, Real scale, Real centre) {
  const Real steps = (value - centre) * (snorm16_steps / scale);
  const Real limit = Real(snorm16_steps);
  const Real held = steps < -limit ? -limit : steps > limit ? limit : steps;
  return held != held ? snorm16_nan : static_cast<std::int16_t>(std::rint(held));
}

}  // namespace detail

/// kLow to kHigh in equal steps: absolute error <= (kHigh - kLow) / 131068, and the rounding of
/// Real at the larger end. Values beyond become the end of the range;
/// NaN stays NaN.
template <double kLow, double kHigh>
struct Snorm16 {
  static_assert(kLow < kHigh, "the range of a Snorm16 goes from a number to a larger one");
  static constexpr const char* name = "snorm16";
  template <class Real>
  using Stored = std::int16_t;
  template <class Real>
  static constexpr ElementType type = ElementType::snorm16;
  static constexpr double scale = kHigh / 2 - kLow / 2, centre = kHigh / 2 + kLow / 2;

  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static Real decode(std::int16_t stored) {
    return detail::snorm16_to_real<Real>(stored, Real(scale), Real(centre));
  }
  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static std::int16_t encode(Real value) {
    return detail::real_to_snorm16<Real>(value, Real(scale), Real(centre));
  }
};

}  // namespace physgen::format
