// Storage formats of W numbers side by side: from memory to numbers to compute with, and back.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/detail/simd_masks.h>
#include <physgen/format.h>

#include <type_traits>
#include <xsimd/xsimd.hpp>

namespace physgen::detail {

/// Whether the processor's own conversion of halves is that of the format: of a power of two, or another factor.
template <class Format, class T>
inline constexpr bool is_half_of_floats =
    format::FromLibrary<Format> && Format::template type<T> == ElementType::half && Format::centre == 0 &&
    std::is_same_v<T, float>;

/// W numbers as they lie in memory, to W numbers to compute with, and back. Loops that compilers turn into packs; where
/// an instruction converts a whole pack, it is named (with a mask of all lanes: of the others' operand g++ warns).
template <class Format, class T, int W>
void decode_lanes(const typename Format::template Stored<T>* stored, T* values) {
#if defined(__F16C__) && defined(__AVX512F__)
  if constexpr (is_half_of_floats<Format, T> && W == 16) {
    const __m512 wide = _mm512_maskz_cvtph_ps(0xffff, _mm256_load_si256(reinterpret_cast<const __m256i*>(stored)));
    return _mm512_store_ps(values, _mm512_mul_ps(wide, _mm512_set1_ps(float(Format::scale))));
  }
#endif
#if defined(__F16C__)
  if constexpr (is_half_of_floats<Format, T> && W == 8) {
    const __m256 wide = _mm256_cvtph_ps(_mm_load_si128(reinterpret_cast<const __m128i*>(stored)));
    return _mm256_store_ps(values, _mm256_mul_ps(wide, _mm256_set1_ps(float(Format::scale))));
  }
#endif
  for (int l = 0; l < W; ++l) values[l] = Format::template decode<T>(stored[l]);
}
template <class Format, class T, int W>
void encode_lanes(const T* values, typename Format::template Stored<T>* stored) {
#if defined(__F16C__) && defined(__AVX512F__)
  if constexpr (is_half_of_floats<Format, T> && W == 16) {
    const __m512 scaled = _mm512_mul_ps(_mm512_load_ps(values), _mm512_set1_ps(float(1 / Format::scale)));
    return _mm256_store_si256(reinterpret_cast<__m256i*>(stored),
                              _mm512_maskz_cvtps_ph(0xffff, scaled, _MM_FROUND_TO_NEAREST_INT));
  }
#endif
#if defined(__F16C__)
  if constexpr (is_half_of_floats<Format, T> && W == 8) {
    const __m256 scaled = _mm256_mul_ps(_mm256_load_ps(values), _mm256_set1_ps(float(1 / Format::scale)));
    return _mm_store_si128(reinterpret_cast<__m128i*>(stored), _mm256_cvtps_ph(scaled, _MM_FROUND_TO_NEAREST_INT));
  }
#endif
  for (int l = 0; l < W; ++l) stored[l] = Format::template encode<T>(values[l]);
}

}  // namespace physgen::detail

#pragma pop_macro("I")
