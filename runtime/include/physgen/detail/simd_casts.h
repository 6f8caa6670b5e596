// Packs of different types in one kernel: conversions between float, double and integer lanes, and masks that were
// compared in one type and select or are joined in another.
#pragma once

#include <physgen/detail/lanewise.h>
#include <physgen/detail/simd_numbers.h>
#include <physgen/simd/simd_access.h>

#include <cstdint>

namespace physgen::detail {

/// Bit l is lane l of a mask.
template <class T, class A>
[[nodiscard]] std::uint64_t bits_of(const xsimd::batch_bool<T, A>& mask) {
  constexpr std::size_t width = xsimd::batch_bool<T, A>::size;
  using Register = typename xsimd::batch_bool<T, A>::register_type;
  if constexpr (sizeof(Register) < 16) {  // of AVX-512: a mask register
    return std::uint64_t{mask.data} & (~std::uint64_t{0} >> (64 - width));
  } else {
#ifdef __SSE2__
    constexpr std::size_t lane = sizeof(Register) / width;
    if constexpr (sizeof(Register) == 16 && lane == 8) {
      return static_cast<unsigned>(_mm_movemask_pd(std::bit_cast<__m128d>(mask.data)));
    } else if constexpr (sizeof(Register) == 16 && lane == 4) {
      return static_cast<unsigned>(_mm_movemask_ps(std::bit_cast<__m128>(mask.data)));
    }
#endif
#ifdef __AVX__
    if constexpr (sizeof(Register) == 32 && lane == 8) {
      return static_cast<unsigned>(_mm256_movemask_pd(std::bit_cast<__m256d>(mask.data)));
    } else if constexpr (sizeof(Register) == 32 && lane == 4) {
      return static_cast<unsigned>(_mm256_movemask_ps(std::bit_cast<__m256>(mask.data)));
    }
#endif
    alignas(64) std::array<bool, width> lanes;
    mask.store_unaligned(lanes.data());
    std::uint64_t bits = 0;
    for (std::size_t l = 0; l < width; ++l) bits |= std::uint64_t{lanes[l]} << l;
    return bits;
  }
}

/// 0, 1, 2, ... as lanes of T.
template <class T, int W>
[[nodiscard]] batch_t<T, W> counting() {
  alignas(64) std::array<T, W> lanes;
  for (int l = 0; l < W; ++l) lanes[static_cast<std::size_t>(l)] = static_cast<T>(l);
  return batch_t<T, W>::load_aligned(lanes.data());
}

/// The mask of lanes of T that has these bits.
template <class T, class A>
[[nodiscard]] xsimd::batch_bool<T, A> mask_of(std::uint64_t bits) {
  using Mask = xsimd::batch_bool<T, A>;
  using Register = typename Mask::register_type;
  if constexpr (sizeof(Register) < 16) {
    return Mask(static_cast<Register>(bits));
  } else {
    using Integers = xsimd::batch<std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>, A>;
    using Lane = typename Integers::value_type;
    alignas(64) std::array<Lane, Mask::size> of_lane;
    for (std::size_t l = 0; l < Mask::size; ++l) of_lane[l] = Lane{1} << l;
    const Integers own = Integers::load_aligned(of_lane.data());
    return Mask(std::bit_cast<Register>(((Integers(static_cast<Lane>(bits)) & own) == own).data));
  }
}

}  // namespace physgen::detail

namespace physgen::math::detail {

/// As compilers convert the elements of their vector types, by one instruction where there is one.
template <class To, class T, class A>
struct Cast<To, xsimd::batch<T, A>> {
  static constexpr int width = static_cast<int>(xsimd::batch<T, A>::size);
  using type = batch_t<To, width>;
  static type of(const xsimd::batch<T, A>& x) {
    using Source [[gnu::vector_size(sizeof(T) * width)]] = T;
    using Target [[gnu::vector_size(sizeof(To) * width)]] = To;
    const Target converted = __builtin_convertvector(std::bit_cast<Source>(x.data), Target);
    return type(std::bit_cast<typename type::register_type>(converted));
  }
};

}  // namespace physgen::math::detail

namespace xsimd {

/// As xsimd's own, for a condition on lanes of another type.
template <class U, class B, class T, class A>
  requires(!std::is_same_v<batch_bool<U, B>, batch_bool<T, A>> && batch_bool<U, B>::size == batch<T, A>::size)
inline batch<T, A> select(const batch_bool<U, B>& condition, const batch<T, A>& a, const batch<T, A>& b) {
  return select(physgen::detail::mask_of<T, A>(physgen::detail::bits_of(condition)), a, b);
}

/// Joins masks on lanes of different types to one on lanes of the first's type.
template <class T, class A, class U, class B>
  requires(!std::is_same_v<batch_bool<U, B>, batch_bool<T, A>> && batch_bool<U, B>::size == batch_bool<T, A>::size)
inline batch_bool<T, A> operator&&(const batch_bool<T, A>& a, const batch_bool<U, B>& b) {
  return a && physgen::detail::mask_of<T, A>(physgen::detail::bits_of(b));
}
template <class T, class A, class U, class B>
  requires(!std::is_same_v<batch_bool<U, B>, batch_bool<T, A>> && batch_bool<U, B>::size == batch_bool<T, A>::size)
inline batch_bool<T, A> operator||(const batch_bool<T, A>& a, const batch_bool<U, B>& b) {
  return a || physgen::detail::mask_of<T, A>(physgen::detail::bits_of(b));
}

/// Joins a condition that all lanes have with a mask.
template <class T, class A>
inline batch_bool<T, A> operator&&(const batch_bool<T, A>& a, std::same_as<bool> auto b) {
  return a && batch_bool<T, A>(b);
}
template <class T, class A>
inline batch_bool<T, A> operator||(const batch_bool<T, A>& a, std::same_as<bool> auto b) {
  return a || batch_bool<T, A>(b);
}
template <class T, class A>
inline batch_bool<T, A> operator&&(std::same_as<bool> auto a, const batch_bool<T, A>& b) {
  return batch_bool<T, A>(a) && b;
}
template <class T, class A>
inline batch_bool<T, A> operator||(std::same_as<bool> auto a, const batch_bool<T, A>& b) {
  return batch_bool<T, A>(a) || b;
}

}  // namespace xsimd
