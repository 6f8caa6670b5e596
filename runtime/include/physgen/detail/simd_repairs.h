// Repairs of what packs get wrong with xsimd 8.1 or g++ 12. simd.h includes them behind xsimd.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/detail/simd_registers.h>

#include <concepts>
#include <cstddef>
#include <cstdint>
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

// With AVX, xsimd's `!=` of floating numbers is false where one is NaN; everywhere else it is true. These are
// specialisations of its member functions. PHYSGEN_UNEQUAL is undefined below.
#define PHYSGEN_UNEQUAL(T, A, unequal)                                                       \
  template <>                                                                                \
  inline batch_bool<T, A> batch<T, A>::operator!=(const batch<T, A>& other) const noexcept { \
    return batch_bool<T, A>(unequal(data, other.data, _CMP_NEQ_UQ));                         \
  }
#define PHYSGEN_UNEQUAL_IN_256_BITS(A) \
  PHYSGEN_UNEQUAL(float, A, _mm256_cmp_ps) PHYSGEN_UNEQUAL(double, A, _mm256_cmp_pd)
#define PHYSGEN_UNEQUAL_IN_512_BITS(A) \
  PHYSGEN_UNEQUAL(float, A, _mm512_cmp_ps_mask) PHYSGEN_UNEQUAL(double, A, _mm512_cmp_pd_mask)
#if XSIMD_WITH_AVX
PHYSGEN_UNEQUAL_IN_256_BITS(avx)
#endif
#if XSIMD_WITH_FMA3_AVX
PHYSGEN_UNEQUAL_IN_256_BITS(fma3<avx>)
#endif
#if XSIMD_WITH_AVX2
PHYSGEN_UNEQUAL_IN_256_BITS(avx2)
#endif
#if XSIMD_WITH_FMA3_AVX2
PHYSGEN_UNEQUAL_IN_256_BITS(fma3<avx2>)
#endif
#if XSIMD_WITH_AVX512F
PHYSGEN_UNEQUAL_IN_512_BITS(avx512f)
#endif
#if XSIMD_WITH_AVX512CD
PHYSGEN_UNEQUAL_IN_512_BITS(avx512cd)
#endif
#if XSIMD_WITH_AVX512DQ
PHYSGEN_UNEQUAL_IN_512_BITS(avx512dq)
#endif
#if XSIMD_WITH_AVX512BW
PHYSGEN_UNEQUAL_IN_512_BITS(avx512bw)
#endif
#undef PHYSGEN_UNEQUAL_IN_512_BITS
#undef PHYSGEN_UNEQUAL_IN_256_BITS
#undef PHYSGEN_UNEQUAL

// With AVX-512, xsimd's -x is 0 - x, which loses the sign of a zero: `atan2(-y, x)` would be off by a whole turn. These
// are specialisations of its member functions. PHYSGEN_NEGATIVE is undefined below.
#define PHYSGEN_NEGATIVE(A)                                              \
  template <>                                                            \
  inline batch<float, A> batch<float, A>::operator-() const noexcept {   \
    return batch<float, A>(-data);                                       \
  }                                                                      \
  template <>                                                            \
  inline batch<double, A> batch<double, A>::operator-() const noexcept { \
    return batch<double, A>(-data);                                      \
  }
#if XSIMD_WITH_AVX512F
PHYSGEN_NEGATIVE(avx512f)
#endif
#if XSIMD_WITH_AVX512CD
PHYSGEN_NEGATIVE(avx512cd)
#endif
#if XSIMD_WITH_AVX512DQ
PHYSGEN_NEGATIVE(avx512dq)
#endif
#if XSIMD_WITH_AVX512BW
PHYSGEN_NEGATIVE(avx512bw)
#endif
#undef PHYSGEN_NEGATIVE

#if defined(__AVX512VL__) && defined(__AVX512DQ__)
/// With AVX512VL, g++ 12 drops the negation of a mask, `select(a != b, x, y)`, when it blends integers byte by byte, as
/// xsimd does: the choice is inverted. Blends by a mask register are right.
template <std::integral T, class A>
  requires(sizeof(batch<T, A>) <= 32 && sizeof(T) >= 4)
inline batch<T, A> select(const batch_bool<T, A>& condition, const batch<T, A>& a, const batch<T, A>& b) {
  if constexpr (sizeof(a) == 32 && sizeof(T) == 4) {
    return batch<T, A>(_mm256_mask_blend_epi32(_mm256_movepi32_mask(condition.data), b.data, a.data));
  } else if constexpr (sizeof(a) == 32) {
    return batch<T, A>(_mm256_mask_blend_epi64(_mm256_movepi64_mask(condition.data), b.data, a.data));
  } else if constexpr (sizeof(T) == 4) {
    return batch<T, A>(_mm_mask_blend_epi32(_mm_movepi32_mask(condition.data), b.data, a.data));
  } else {
    return batch<T, A>(_mm_mask_blend_epi64(_mm_movepi64_mask(condition.data), b.data, a.data));
  }
}
#endif

#ifdef __AVX512BW__
/// xsimd's own does not compile without optimization.
template <std::integral T>
  requires(sizeof(T) >= 4)
inline batch<T, avx512bw> select(const batch_bool<T, avx512bw>& condition, const batch<T, avx512bw>& a,
                                 const batch<T, avx512bw>& b) {
  if constexpr (sizeof(T) == 4) {
    return _mm512_mask_blend_epi32(condition.data, b.data, a.data);
  } else {
    return _mm512_mask_blend_epi64(condition.data, b.data, a.data);
  }
}
#endif

}  // namespace xsimd

#pragma pop_macro("I")
