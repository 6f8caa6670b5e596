// Functions that formats share: doubles become floats so that a second rounding does no harm, and numbers are scaled.
#pragma once

#include <physgen/config.h>

#include <bit>
#include <cmath>

namespace physgen::format::detail {

/// The float next to x towards zero, with its last bit set unless it is x: rounding it once more, to a format with at
/// least two bits less, gives what rounding x would have given.
[[nodiscard]] PHYSGEN_FUNCTION inline float to_odd(double x) {
  const auto nearest = static_cast<float>(x);
  const double back = nearest;
  if (back == x || x != x) return nearest;
  auto bits = std::bit_cast<std::uint32_t>(nearest);
  const bool beyond = x < 0 ? back < x : back > x;  // nearest is further from zero than x
  if (beyond) --bits;
  return std::bit_cast<float>(bits | 1U);
}
[[nodiscard]] PHYSGEN_FUNCTION inline float to_odd(float x) { return x; }

/// centre + scale * value, and back: the same bits in accessors, packs and copies.
template <class S>
[[nodiscard]] PHYSGEN_FUNCTION inline S to_scale(S value, S scale, S centre) {
  return centre == 0 ? value * scale : std::fma(value, scale, centre);
}
/// @param divided whether the result is stored as a float or double. Then it is the quotient: by 1 / scale, which is
/// rounded, a number that is read and stored again and again would move each time. In 16 bits that is rounded away.
template <class S>
[[nodiscard]] PHYSGEN_FUNCTION inline S from_scale(S value, double scale, S centre, bool divided) {
  return divided ? (value - centre) / static_cast<S>(scale) : (value - centre) * static_cast<S>(1 / scale);
}

/// 2^exponent, for exponents of normal floats.
[[nodiscard]] PHYSGEN_FUNCTION constexpr double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

}  // namespace physgen::format::detail
