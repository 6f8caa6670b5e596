// Functions of packs that xsimd 8.1 has wrong in places: a result off by more than 4 units in the last place, or not
// the C library's for zeros, infinities, and numbers near the ends of the range. Those lanes are computed anew by the C
// library's function. As with fma() in simd.h, these overloads are more special than xsimd's own.
#pragma once

#include <physgen/detail/simd_masks.h>

#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <xsimd/xsimd.hpp>

namespace physgen::detail {

/// function(lane of x...) lane by lane, where `where` holds; elsewhere the lanes of `known`.
template <class T, class A, class Function, class... X>
[[gnu::noinline]] xsimd::batch<T, A> lane_by_lane(const xsimd::batch_bool<T, A>& where, const xsimd::batch<T, A>& known,
                                                  const Function& function, const X&... x) {
  constexpr std::size_t width = xsimd::batch<T, A>::size;
  alignas(64) std::array<T, width> result;
  alignas(64) std::array<bool, width> wrong;
  known.store_aligned(result.data());
  where.store_unaligned(wrong.data());
  for (std::size_t l = 0; l < width; ++l) {
    if (wrong[l]) result[l] = function(x.get(l)...);
  }
  return xsimd::batch<T, A>::load_aligned(result.data());
}
/// The same where any lane is wrong, which is rare.
template <class T, class A, class Function, class... X>
[[gnu::always_inline]] inline xsimd::batch<T, A> mend(const xsimd::batch_bool<T, A>& where,
                                                      const xsimd::batch<T, A>& known, const Function& function,
                                                      const X&... x) {
  if (xsimd::any(where)) [[unlikely]]
    return lane_by_lane(where, known, function, x...);
  return known;
}

template <class T, class A>
xsimd::batch<T, A> mended_exp(const xsimd::batch<T, A>& x) {
  constexpr T least_normal = sizeof(T) == 4 ? T(-87.3) : T(-708.3);  // results below it are subnormal
  constexpr T largest = sizeof(T) == 4 ? T(88.3) : T(709.3);         // above it xsimd gives infinity, too early
  using S = xsimd::batch<T, A>;
  return mend(x < S(least_normal) || x > S(largest), xsimd::kernel::exp<A>(x, A{}), [](T a) { return std::exp(a); }, x);
}
template <class T, class A>
xsimd::batch<T, A> mended_expm1(const xsimd::batch<T, A>& x) {
  constexpr T largest = sizeof(T) == 4 ? T(88.3) : T(709.3);
  return mend(x > xsimd::batch<T, A>(largest), xsimd::kernel::expm1<A>(x, A{}), [](T a) { return std::expm1(a); }, x);
}
template <class T, class A>
xsimd::batch<T, A> mended_log(const xsimd::batch<T, A>& x) {
  using S = xsimd::batch<T, A>;
  return mend(x < S(std::numeric_limits<T>::min()), xsimd::kernel::log<A>(x, A{}), [](T a) { return std::log(a); }, x);
}
template <class T, class A>
xsimd::batch<T, A> mended_cbrt(const xsimd::batch<T, A>& x) {
  using S = xsimd::batch<T, A>;
  return mend(
      xsimd::abs(x) < S(std::numeric_limits<T>::min()), xsimd::kernel::cbrt<A>(x, A{}),
      [](T a) { return std::cbrt(a); }, x);
}
template <class T, class A>
xsimd::batch<T, A> mended_pow(const xsimd::batch<T, A>& x, const xsimd::batch<T, A>& y) {
  return lane_by_lane(xsimd::batch_bool<T, A>(true), x, [](T a, T b) { return std::pow(a, b); }, x, y);
}
template <class T, class A>
xsimd::batch<T, A> mended_fmod(const xsimd::batch<T, A>& x, const xsimd::batch<T, A>& y) {
  return lane_by_lane(xsimd::batch_bool<T, A>(true), x, [](T a, T b) { return std::fmod(a, b); }, x, y);
}
/// Of both zero and of both infinite, and where the quotient is neither 0 nor a normal number.
template <class T, class A>
xsimd::batch<T, A> mended_atan2(const xsimd::batch<T, A>& y, const xsimd::batch<T, A>& x) {
  using S = xsimd::batch<T, A>;
  const S quotient = xsimd::abs(y / x);
  const auto sound = quotient >= S(std::numeric_limits<T>::min()) && quotient <= S(std::numeric_limits<T>::max());
  return mend(!sound, xsimd::kernel::atan2<A>(y, x, A{}), [](T a, T b) { return std::atan2(a, b); }, y, x);
}
/// Where a square over- or underflows.
template <class T, class A>
xsimd::batch<T, A> mended_hypot(const xsimd::batch<T, A>& x, const xsimd::batch<T, A>& y) {
  using S = xsimd::batch<T, A>;
  constexpr T large = sizeof(T) == 4 ? T(0x1p62) : T(0x1p510), small = sizeof(T) == 4 ? T(0x1p-50) : T(0x1p-480);
  const S longer = xsimd::max(xsimd::abs(x), xsimd::abs(y));
  const auto sound = longer <= S(large) && longer >= S(small) && x == x && y == y;
  return mend(!sound, xsimd::sqrt(x * x + y * y), [](T a, T b) { return std::hypot(a, b); }, x, y);
}

}  // namespace physgen::detail

namespace xsimd {

// For float and double each, which is what makes them more special. PHYSGEN_MENDED_ONE and _TWO are undefined below.
#define PHYSGEN_MENDED_ONE(T, name)                 \
  template <class A>                                \
  inline batch<T, A> name(const batch<T, A>& x) {   \
    return physgen::detail::mended_##name<T, A>(x); \
  }
#define PHYSGEN_MENDED_TWO(T, name)                                     \
  template <class A>                                                    \
  inline batch<T, A> name(const batch<T, A>& x, const batch<T, A>& y) { \
    return physgen::detail::mended_##name<T, A>(x, y);                  \
  }
PHYSGEN_MENDED_ONE(float, exp)
PHYSGEN_MENDED_ONE(double, exp)
PHYSGEN_MENDED_ONE(float, expm1)
PHYSGEN_MENDED_ONE(double, expm1)
PHYSGEN_MENDED_ONE(float, log)
PHYSGEN_MENDED_ONE(double, log)
PHYSGEN_MENDED_ONE(float, cbrt)
PHYSGEN_MENDED_ONE(double, cbrt)
PHYSGEN_MENDED_TWO(float, pow)
PHYSGEN_MENDED_TWO(double, pow)
PHYSGEN_MENDED_TWO(float, fmod)
PHYSGEN_MENDED_TWO(double, fmod)
PHYSGEN_MENDED_TWO(float, atan2)
PHYSGEN_MENDED_TWO(double, atan2)
PHYSGEN_MENDED_TWO(float, hypot)
PHYSGEN_MENDED_TWO(double, hypot)
#undef PHYSGEN_MENDED_ONE
#undef PHYSGEN_MENDED_TWO

}  // namespace xsimd
