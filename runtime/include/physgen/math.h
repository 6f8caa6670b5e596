// Scalar functions for kernels that are written once: float and double here, on host and CUDA device; simd.h adds
// packs. Kernels call them unqualified (`using math::sqrt; sqrt(x)`), so that argument-dependent lookup finds those of
// packs.
#pragma once

#include <physgen/config.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace physgen::math {

// The overload set is closed (float, double): a mixed call such as max(x, 1.0) does not compile and silently widen.
#define PHYSGEN_DETAIL_UNARY(name)                                     \
  PHYSGEN_FUNCTION inline float name(float x) { return std::name(x); } \
  PHYSGEN_FUNCTION inline double name(double x) { return std::name(x); }
PHYSGEN_DETAIL_UNARY(sqrt)
PHYSGEN_DETAIL_UNARY(abs)
PHYSGEN_DETAIL_UNARY(log)
PHYSGEN_DETAIL_UNARY(log1p)
#undef PHYSGEN_DETAIL_UNARY

PHYSGEN_FUNCTION inline float copysign(float x, float y) { return std::copysign(x, y); }
PHYSGEN_FUNCTION inline double copysign(double x, double y) { return std::copysign(x, y); }
PHYSGEN_FUNCTION inline float fma(float x, float y, float z) { return std::fma(x, y, z); }
PHYSGEN_FUNCTION inline double fma(double x, double y, double z) { return std::fma(x, y, z); }

/// The smaller and the larger of two numbers. Which operand comes back when one is NaN is unspecified.
PHYSGEN_FUNCTION inline float min(float x, float y) { return y < x ? y : x; }
PHYSGEN_FUNCTION inline double min(double x, double y) { return y < x ? y : x; }
PHYSGEN_FUNCTION inline float max(float x, float y) { return x < y ? y : x; }
PHYSGEN_FUNCTION inline double max(double x, double y) { return x < y ? y : x; }

/// `condition ? a : b`, both evaluated: the form that exists for packs, too.
PHYSGEN_FUNCTION inline float select(bool condition, float a, float b) { return condition ? a : b; }
PHYSGEN_FUNCTION inline double select(bool condition, double a, double b) { return condition ? a : b; }

/// A power of two and its inverse, both normal numbers.
template <class S>
struct PowerOfTwo {
  S scale, inverse;
};

/// What generic code must know of a scalar type beyond its arithmetic; simd.h specialises it for packs.
template <class S>
struct ScalarTraits {
  static_assert(std::numeric_limits<S>::is_iec559, "include <physgen/simd.h> for packs");
  using Real = S;                  ///< the type of one number: S itself, or the element type of a pack
  static constexpr int width = 1;  ///< how many numbers one S holds

  /// 1 / sqrt(x) for normal x > 0; error <= 2 eps.
  PHYSGEN_FUNCTION static S inverse_sqrt(S x) {
#ifdef __CUDA_ARCH__
    return ::rsqrt(x);
#else
    return S(1) / std::sqrt(x);
#endif
  }

  /// The power of two that brings finite x >= 0 into [4, 8), with its inverse. Subnormal x (and zero) get the largest
  /// one whose inverse is normal; both ends are chosen so that neither number can over- or underflow.
  PHYSGEN_FUNCTION static PowerOfTwo<S> normalising_scale(S x) {
    using Bits = std::conditional_t<sizeof(S) == 4, std::int32_t, std::int64_t>;
    constexpr int mantissa = std::numeric_limits<S>::digits - 1;
    constexpr Bits bias = std::numeric_limits<S>::max_exponent - 1;
    const Bits exponent = std::bit_cast<Bits>(x) >> mantissa;
    const Bits wanted = 2 * bias + 2 - exponent;
    const Bits scale = wanted < 2 * bias - 1 ? wanted : 2 * bias - 1;
    return {std::bit_cast<S>(scale << mantissa), std::bit_cast<S>((2 * bias - scale) << mantissa)};
  }
};

}  // namespace physgen::math
