// bfloat16 as bits.
#pragma once

#include <physgen/config.h>

#include <bit>

namespace physgen::format::detail {

[[nodiscard]] PHYSGEN_FUNCTION inline float bfloat16_to_float(std::uint16_t bits) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(bits) << 16);
}

/// The nearest one, ties to even.
[[nodiscard]] PHYSGEN_FUNCTION inline std::uint16_t float_to_bfloat16(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  if ((bits & 0x7fffffffU) > 0x7f800000U) return static_cast<std::uint16_t>(bits >> 16 | 0x40U);  // NaN stays NaN
  return static_cast<std::uint16_t>((bits + 0x7fffU + (bits >> 16 & 1U)) >> 16);
}

}  // namespace physgen::format::detail
