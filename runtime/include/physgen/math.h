// Scalar functions for kernels that are written once: float and double here, on host and CUDA device; simd.h adds
// packs. Kernels call them unqualified (`using math::sqrt; sqrt(x)`), so that argument-dependent lookup finds those of
// packs.
#pragma once

#include <physgen/config.h>

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace physgen::math {

using std::abs;
using std::copysign;
using std::fma;
using std::log;
using std::log1p;
using std::sqrt;

// Templates, so that code which opens these namespaces in a CUDA file still means CUDA's own min and max by theirs.

/// The smaller and the larger of two numbers. Which operand comes back when one is NaN is unspecified.
template <std::floating_point S>
PHYSGEN_FUNCTION inline S min(const S& x, const S& y) {
  return y < x ? y : x;
}
template <std::floating_point S>
PHYSGEN_FUNCTION inline S max(const S& x, const S& y) {
  return x < y ? y : x;
}

/// `condition ? a : b`, both evaluated: the form that exists for packs, too.
template <std::floating_point S>
PHYSGEN_FUNCTION inline S select(bool condition, const S& a, const S& b) {
  return condition ? a : b;
}

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
