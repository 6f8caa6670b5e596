// Numbers in equal steps over a range.
#pragma once

#include <physgen/detail/rounding.h>
#include <physgen/format/element_type.h>

#include <bit>
#include <cmath>

namespace physgen::format::detail {

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

}  // namespace physgen::format::detail
