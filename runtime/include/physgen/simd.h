// SIMD packs (xsimd batches) as scalars of kernels and of Eigen matrices on the CPU. Never included by CUDA translation
// units. sqrt, abs, log1p, select and the rest come from namespace xsimd by argument-dependent lookup.
#pragma once

#ifdef __CUDACC__
#error \
    "physgen/simd.h and parallel_for.h are for host translation units (.cpp); .cu: <physgen/cuda/parallel_for.h>, float, double"
#endif

#include <physgen/detail/simd_functions.h>
#include <physgen/detail/simd_masks.h>
#include <physgen/detail/simd_repairs.h>
#include <physgen/math.h>

#include <Eigen/Core>
#include <type_traits>
#include <xsimd/xsimd.hpp>

namespace xsimd {

// xsimd 8.1 has no fused multiply-add for AVX-512 and for SSE: it multiplies, then adds. These overloads are more
// special than its own, and found wherever that one is. Kernels name each fusion, and contraction by the compiler is
// off, so that packs of all widths, single numbers and CUDA round alike.
template <std::floating_point T, class A>
[[gnu::always_inline]] inline batch<T, A> fma(const batch<T, A>& x, const batch<T, A>& y, const batch<T, A>& z) {
  [[maybe_unused]] constexpr std::size_t bytes = sizeof(x), of_one = sizeof(T);
#if defined(__AVX512F__)
  if constexpr (bytes == 64 && of_one == 4) return _mm512_fmadd_ps(x, y, z);
  if constexpr (bytes == 64 && of_one == 8) return _mm512_fmadd_pd(x, y, z);
#endif
#if defined(__FMA__)
  if constexpr (bytes == 32 && of_one == 4) return _mm256_fmadd_ps(x, y, z);
  if constexpr (bytes == 32 && of_one == 8) return _mm256_fmadd_pd(x, y, z);
  if constexpr (bytes == 16 && of_one == 4) return _mm_fmadd_ps(x, y, z);
  if constexpr (bytes == 16 && of_one == 8) return _mm_fmadd_pd(x, y, z);
#endif
  return kernel::fma<A>(x, y, z, A{});
}

}  // namespace xsimd

namespace physgen {

static_assert(!std::is_constructible_v<bool, xsimd::batch_bool<float>> &&
                  !std::is_constructible_v<bool, xsimd::batch_bool<std::int32_t>>,
              "masks convert to bool with this xsimd, so that `if (mask)` would mean any lane: see simd_masks.h, which "
              "must be included before <xsimd/xsimd.hpp>");

/// The widest batch of the target architecture.
template <class Real>
using Batch = xsimd::batch<Real>;

namespace math {

namespace detail {

/// Bits of the estimates that x86 has for packs of float; 0 where there are none.
template <class S>
constexpr int estimate_bits() {
#if defined(__AVX__)
  if constexpr (std::is_same_v<typename S::value_type, float>) return sizeof(S) == 64 ? 14 : sizeof(S) == 32 ? 11 : 0;
#endif
  return 0;
}

template <class S>
S rough_inverse_sqrt(const S& x) {
#if defined(__AVX512F__)
  if constexpr (estimate_bits<S>() == 14) return _mm512_rsqrt14_ps(x);
#endif
#if defined(__AVX__)
  if constexpr (estimate_bits<S>() == 11) return _mm256_rsqrt_ps(x);
#endif
  return S(typename S::value_type(1)) / xsimd::sqrt(x);
}

template <class S>
S rough_inverse(const S& x) {
#if defined(__AVX512F__)
  if constexpr (estimate_bits<S>() == 14) return _mm512_rcp14_ps(x);
#endif
#if defined(__AVX__)
  if constexpr (estimate_bits<S>() == 11) return _mm256_rcp_ps(x);
#endif
  return S(typename S::value_type(1)) / x;
}

/// An estimate and Newton's steps, each of which doubles its bits: a third of the time of a root and a quotient.
template <class S>
S inverse_sqrt(const S& x) {
  using T = typename S::value_type;
  S y = rough_inverse_sqrt(x);
  constexpr int bits = estimate_bits<S>();
  for (int have = bits; have != 0 && have < 24; have *= 2) {
    const S rest = xsimd::fma(-x * y, y, S(T(1)));
    y = xsimd::fma(y * S(T(0.5)), rest, y);
  }
  return y;
}

}  // namespace detail

template <class T, class A>
struct ScalarTraits<xsimd::batch<T, A>> {
  using S = xsimd::batch<T, A>;
  using Real = T;
  static constexpr int width = static_cast<int>(S::size);

  static S inverse_sqrt(const S& x) { return detail::inverse_sqrt(x); }
  static S rough_inverse_sqrt(const S& x) { return detail::rough_inverse_sqrt(x); }
  static S rough_inverse(const S& x) { return detail::rough_inverse(x); }

  static PowerOfTwo<S> normalising_scale(const S& x) {
    using Int = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
    using Bits = xsimd::batch<Int, A>;
    constexpr int mantissa = std::numeric_limits<T>::digits - 1;
    constexpr Int bias = std::numeric_limits<T>::max_exponent - 1;
    const Bits exponent = xsimd::bitwise_cast<Bits>(x) >> mantissa;
    const Bits scale = xsimd::min(Bits(2 * bias + 2) - exponent, Bits(2 * bias - 1));
    return {xsimd::bitwise_cast<S>(scale << mantissa), xsimd::bitwise_cast<S>((Bits(2 * bias) - scale) << mantissa)};
  }

  static MantissaExponent<S> split(const S& x) {
    using Int = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
    using Bits = xsimd::batch<Int, A>;
    constexpr int mantissa = std::numeric_limits<T>::digits - 1;
    constexpr Int bias = std::numeric_limits<T>::max_exponent - 1;
    constexpr Int least = std::bit_cast<Int>(T(0.70710678118654752440L));
    // An integer below 2^mantissa, put into the low bits of this number, is added to it: the conversion to S.
    constexpr T holder = static_cast<T>(Int(1) << mantissa);
    const Bits raised = xsimd::bitwise_cast<Bits>(x) + Bits((bias << mantissa) - least);
    const Bits low = raised & Bits((Int(1) << mantissa) - 1);
    const Bits held = (raised >> mantissa) + Bits(std::bit_cast<Int>(holder));
    return {xsimd::bitwise_cast<S>(low + Bits(least)), xsimd::bitwise_cast<S>(held) - S(holder + T(bias))};
  }
};

}  // namespace math
}  // namespace physgen

namespace Eigen {

// ReadCost and friends of 1 keep Eigen on lazy, fully unrolled products of small fixed-size matrices.
template <class T, class A>
struct NumTraits<xsimd::batch<T, A>> : GenericNumTraits<T> {
  using Real = xsimd::batch<T, A>;
  using NonInteger = xsimd::batch<T, A>;
  using Nested = xsimd::batch<T, A>;
  using Literal = T;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
  static Real epsilon() { return Real(std::numeric_limits<T>::epsilon()); }
  static Real dummy_precision() { return Real(NumTraits<T>::dummy_precision()); }
  static Real highest() { return Real(std::numeric_limits<T>::max()); }
  static Real lowest() { return Real(std::numeric_limits<T>::lowest()); }
};

// Lets a matrix of packs be scaled by one number: `Matrix<Batch<float>, 3, 3>{} * 0.5f`.
template <class T, class A, class BinaryOp>
struct ScalarBinaryOpTraits<xsimd::batch<T, A>, T, BinaryOp> {
  using ReturnType = xsimd::batch<T, A>;
};
template <class T, class A, class BinaryOp>
struct ScalarBinaryOpTraits<T, xsimd::batch<T, A>, BinaryOp> {
  using ReturnType = xsimd::batch<T, A>;
};

}  // namespace Eigen
