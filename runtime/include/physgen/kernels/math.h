// Scalar functions for kernels that are written once: float and double here, on host and CUDA device; simd.h adds
// packs. Kernels call them unqualified (`using namespace physgen::math; sqrt(x)`), so that argument-dependent lookup
// finds those of packs.
#pragma once

#include <physgen/kernels/pack.h>

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace physgen::math {

// These take single numbers; xsimd has the same for packs, but for those that simd_functions.h mends. Errors of packs
// in units in the last place, the worst of 1e6 arguments in each of three ranges, for float and double, SSE4, AVX2 and
// AVX-512: sqrt, floor, ceil, trunc, round, abs, copysign and fmod exact or rounded once; pow 0.51; log, log1p 0.9;
// exp, sinh, cosh, tanh, hypot, acos, expm1 2.3; sin, cos 2.4; asin, atan, atan2 2.6; cbrt 3.2; tan 3.3; sin, cos and
// tan take arguments of any size, and next to multiples of pi/2 have these errors, too. pow and fmod call the C library
// lane by lane. NaN, infinities and zeros give what the C library gives, but packs lose the sign of a zero in expm1 and
// log1p, and before SSE4 in floor, ceil, trunc and round. Errors of single numbers are the C library's, and on a device
// those of CUDA's manual. So last bits differ between packs, single numbers and CUDA, but for what is exact or rounded
// once.
using std::abs;
using std::acos;
using std::asin;
using std::atan;
using std::atan2;
using std::cbrt;
using std::ceil;
using std::copysign;
using std::cos;
using std::cosh;
using std::exp;
using std::expm1;
using std::floor;
using std::fma;
using std::fmod;
using std::hypot;
using std::isfinite;
using std::isinf;
using std::isnan;
using std::log;
using std::log1p;
using std::round;
using std::sin;
using std::sinh;
using std::sqrt;
using std::tan;
using std::tanh;
using std::trunc;

/// One number, of which packs hold several.
template <class T>
concept Number = std::is_arithmetic_v<T>;
/// One number or a pack.
template <class S>
concept Lanewise = Number<S> || requires { typename S::batch_bool_type; };
namespace detail {
template <class S>
inline constexpr bool holds_integers = std::is_integral_v<S>;
template <class S>
  requires requires { typename S::value_type; }
inline constexpr bool holds_integers<S> = std::is_integral_v<typename S::value_type>;
}  // namespace detail

/// A plain number beside numbers of another type, or beside packs: `max(m, 0)`, `max(m, 0.0)`. Beside integers, one
/// that they can hold: not `max(n, 3000000000U)`.
template <class T, class S>
concept PlainBeside =
    Number<T> && !std::is_same_v<T, S> &&
    ((std::is_integral_v<T> && (sizeof(T) < sizeof(int) || (sizeof(T) == sizeof(int) && std::is_signed_v<T>))) ||
     !detail::holds_integers<S>);

// Templates, so that code which opens these namespaces in a CUDA file still means CUDA's own min and max by theirs.

/// The smaller and the larger of two numbers; either may come back when one is NaN.
template <Number S>
PHYSGEN_FUNCTION inline S min(const S& x, const S& y) {
  return y < x ? y : x;
}
template <Number S>
PHYSGEN_FUNCTION inline S max(const S& x, const S& y) {
  return x < y ? y : x;
}
/// A plain number stands second, and takes the type of the first: `max(m, 0.0)` of a float m is a float.
template <class S, PlainBeside<S> T>
PHYSGEN_FUNCTION inline S min(const S& x, T y) {
  return min(x, all_lanes<S>(y));
}
template <class S, PlainBeside<S> T>
PHYSGEN_FUNCTION inline S max(const S& x, T y) {
  return max(x, all_lanes<S>(y));
}

/// x^y, as std::pow() has it.
template <std::floating_point S>
PHYSGEN_FUNCTION inline S pow(const S& x, const S& y) {
  return std::pow(x, y);
}
template <class S, PlainBeside<S> T>
PHYSGEN_FUNCTION inline S pow(const S& x, T y) {
  return pow(x, all_lanes<S>(y));
}

/// `condition ? a : b`, both evaluated, lane by lane: a condition of packs is a mask, of lanes of any type. `b` may be
/// a plain number. lanewise.h has those of Eigen's vectors and matrices.
template <Lanewise S>
PHYSGEN_FUNCTION inline S select(bool condition, const S& a, const S& b) {
  return condition ? a : b;
}
template <class Condition, Lanewise S, PlainBeside<S> T>
PHYSGEN_FUNCTION inline S select(const Condition& condition, const S& a, T b) {
  return select(condition, a, all_lanes<S>(b));
}

/// x, but not below `low` and not above `high`, which may be plain numbers; NaN stays NaN. @pre low <= high
template <Lanewise S>
PHYSGEN_FUNCTION inline S clamp(const S& x, const S& low, const S& high) {
  return select(x < low, low, select(high < x, high, x));
}
template <Lanewise S, PlainBeside<S> Low>
PHYSGEN_FUNCTION inline S clamp(const S& x, Low low, const S& high) {
  return clamp(x, all_lanes<S>(low), high);
}
template <Lanewise S, class Low, PlainBeside<S> High>
PHYSGEN_FUNCTION inline S clamp(const S& x, const Low& low, High high) {
  return clamp(x, low, all_lanes<S>(high));
}

/// A power of two and its inverse, both normal numbers.
template <class S>
struct PowerOfTwo {
  S scale, inverse;
};

/// x = mantissa * 2^exponent; the exponent is an integer held in an S.
template <class S>
struct MantissaExponent {
  S mantissa, exponent;
};

/// The operations that generic code needs of a scalar type beyond its arithmetic; simd.h specialises it for packs.
template <class S>
struct ScalarTraits {
  static_assert(std::numeric_limits<S>::is_iec559, "include <physgen/simd/simd.h> for packs");
  using Real = S;                  ///< the type of one number: S itself, or the element type of a pack
  static constexpr int width = 1;  ///< how many numbers one S holds

  /// 1 / sqrt(x) for normal x > 0; error <= 2 eps.
  PHYSGEN_FUNCTION static S inverse_sqrt(S x) {
#ifdef __CUDA_ARCH__
    if constexpr (sizeof(S) == 4) return cuda_inverse_sqrt(x);
    return ::rsqrt(x);
#else
    return S(1) / std::sqrt(x);
#endif
  }

  /// Fast estimates of 1 / sqrt(x) and 1 / x, to be refined by a Newton step: float has 11 bits or more, double is
  /// exact to a few eps. For normal x > 0 whose result is normal.
  PHYSGEN_FUNCTION static S rough_inverse_sqrt(S x) { return inverse_sqrt(x); }
  PHYSGEN_FUNCTION static S rough_inverse(S x) {
#ifdef __CUDA_ARCH__
    if constexpr (sizeof(S) == 4) {
      float result;
      asm("rcp.approx.ftz.f32 %0, %1;" : "=f"(result) : "f"(x));
      return result;
    }
#endif
    return S(1) / x;
  }

  /// The power of two that brings finite x >= 0 into [4, 8), with its inverse. x near the smallest normal number and
  /// below gets the largest one whose inverse is normal; both ends are chosen so that neither number can over- or
  /// underflow.
  PHYSGEN_FUNCTION static PowerOfTwo<S> normalising_scale(S x) {
    using Bits = std::conditional_t<sizeof(S) == 4, std::int32_t, std::int64_t>;
    constexpr int mantissa = std::numeric_limits<S>::digits - 1;
    constexpr Bits bias = std::numeric_limits<S>::max_exponent - 1;
    const Bits exponent = std::bit_cast<Bits>(x) >> mantissa;
    const Bits wanted = 2 * bias + 2 - exponent;
    const Bits scale = wanted < 2 * bias - 1 ? wanted : 2 * bias - 1;
    return {std::bit_cast<S>(scale << mantissa), std::bit_cast<S>((2 * bias - scale) << mantissa)};
  }

  /// Splits a normal x > 0 exactly, with sqrt(1/2) <= mantissa < sqrt(2). For other x the result is finite but
  /// meaningless.
  PHYSGEN_FUNCTION static MantissaExponent<S> split(S x) {
    using Bits = std::conditional_t<sizeof(S) == 4, std::uint32_t, std::uint64_t>;
    using Exponent = std::conditional_t<sizeof(S) == 4, std::int32_t, std::int64_t>;
    constexpr int mantissa = std::numeric_limits<S>::digits - 1;
    constexpr Exponent bias = std::numeric_limits<S>::max_exponent - 1;
    constexpr Bits least = std::bit_cast<Bits>(S(0.70710678118654752440L));
    const Bits raised = std::bit_cast<Bits>(x) + ((Bits(bias) << mantissa) - least);
    const Bits low = raised & ((Bits(1) << mantissa) - 1);
    return {std::bit_cast<S>(low + least), static_cast<S>(static_cast<Exponent>(raised >> mantissa) - bias)};
  }

 private:
#ifdef __CUDA_ARCH__
  // One instruction, error < 1.1 eps; CUDA's rsqrtf adds the handling of subnormal x.
  __device__ static float cuda_inverse_sqrt(float x) {
    float result;
    asm("rsqrt.approx.ftz.f32 %0, %1;" : "=f"(result) : "f"(x));
    return result;
  }
#endif
};

}  // namespace physgen::math
