// IEEE half precision: 11 significant bits, magnitudes from 6e-5 (6e-8 with fewer bits) to 65504, times a power of two.
#pragma once

#include <physgen/element_type.h>
#include <physgen/format/rounding.h>

#if defined(__CUDACC__)
#include <cuda_fp16.h>
#endif

namespace physgen::format {

namespace detail {

/// The number that 16 bits of IEEE half precision stand for; exact.
[[nodiscard]] PHYSGEN_FUNCTION inline float half_to_float(std::uint16_t bits) {
#ifdef __CUDA_ARCH__
  return __half2float(__ushort_as_half(bits));
#else
  // The exponent and mantissa as the low part of a float are 2^-112 times the number, subnormal ones included.
  const std::uint32_t magnitude = static_cast<std::uint32_t>(bits & 0x7fffU) << 13;
  const float scaled = std::bit_cast<float>(magnitude) * 0x1p112F;
  const std::uint32_t infinite = magnitude >= 0x0f800000U ? 0x7f800000U : 0U;  // infinity and NaN keep their mantissa
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(scaled) | infinite |
                              static_cast<std::uint32_t>(bits & 0x8000U) << 16);
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

}  // namespace detail

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
