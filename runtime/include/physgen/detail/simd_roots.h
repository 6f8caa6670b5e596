// Roots and quotients of packs: the processor's estimates, and the reciprocal root that Newton's steps make of one.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/detail/simd_masks.h>
#include <physgen/detail/simd_repairs.h>

#include <type_traits>
#include <xsimd/xsimd.hpp>

namespace physgen::math::detail {

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

}  // namespace physgen::math::detail

#pragma pop_macro("I")
