// Half precision as bits, on host and device.
#pragma once

#include <physgen/config.h>

#include <bit>

#if defined(__CUDACC__)
#include <cuda_fp16.h>
#endif

namespace physgen::format::detail {

/// The number that 16 bits of IEEE half precision stand for; exact.
[[nodiscard]] PHYSGEN_FUNCTION inline float half_to_float(std::uint16_t bits) {
#ifdef __CUDA_ARCH__
  return __half2float(__ushort_as_half(bits));
#else
  // Exponent and mantissa are moved to their places in a float. A subnormal half is put behind 2^-14, which is then
  // subtracted: no operation reads a subnormal float, so that programs which flush those to zero keep small halves.
  const std::uint32_t magnitude = static_cast<std::uint32_t>(bits & 0x7fffU) << 13;
  const float small = std::bit_cast<float>(magnitude + 0x38800000U) - 0x1p-14F;
  const std::uint32_t exponent = magnitude >= 0x0f800000U ? 0x70000000U : 0x38000000U;  // infinite and NaN; others
  const std::uint32_t value = magnitude < 0x00800000U ? std::bit_cast<std::uint32_t>(small) : magnitude + exponent;
  return std::bit_cast<float>(value | static_cast<std::uint32_t>(bits & 0x8000U) << 16);
#endif
}

/// The nearest half, ties to even; beyond 65519 infinity.
[[nodiscard]] PHYSGEN_FUNCTION inline std::uint16_t float_to_half(float x) {
#ifdef __CUDA_ARCH__
  return __half_as_ushort(__float2half_rn(x));
#else
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const std::uint32_t sign = bits >> 16 & 0x8000U;
  const std::uint32_t magnitude = bits & 0x7fffffffU;
  if (magnitude > 0x7f800000U) return static_cast<std::uint16_t>(sign | 0x7e00U);   // NaN
  if (magnitude >= 0x477ff000U) return static_cast<std::uint16_t>(sign | 0x7c00U);  // 65520 and more
  if (magnitude < 0x38800000U) {  // subnormal: adding 0.5 leaves multiples of 2^-24, rounded, in the low bits
    const float shifted = std::bit_cast<float>(magnitude) + 0.5F;
    return static_cast<std::uint16_t>(sign | (std::bit_cast<std::uint32_t>(shifted) - 0x3f000000U));
  }
  const std::uint32_t odd = magnitude >> 13 & 1U;
  return static_cast<std::uint16_t>(sign | (magnitude - 0x38000000U + 0xfffU + odd) >> 13);
#endif
}

}  // namespace physgen::format::detail
