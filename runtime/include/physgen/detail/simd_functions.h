// Functions of packs that xsimd 8.1 has wrong in places: a result off by more than 4 units in the last place, or not
// the C library's for zeros, infinities, and numbers near the ends of the range. Those lanes are computed anew by the C
// library's function. As with fma() in simd_repairs.h, these overloads are more special than xsimd's own.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

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

}  // namespace physgen::detail

namespace xsimd {

template <std::floating_point T, class A>
inline batch<T, A> exp(const batch<T, A>& x) {
  constexpr T least_normal = sizeof(T) == 4 ? T(-87.3) : T(-708.3);  // results below it are subnormal
  constexpr T largest = sizeof(T) == 4 ? T(88.3) : T(709.3);         // above it xsimd gives infinity, too early
  using S = batch<T, A>;
  return physgen::detail::mend(
      x < S(least_normal) || x > S(largest), kernel::exp<A>(x, A{}), [](T a) { return std::exp(a); }, x);
}
template <std::floating_point T, class A>
inline batch<T, A> expm1(const batch<T, A>& x) {
  constexpr T largest = sizeof(T) == 4 ? T(88.3) : T(709.3);
  return physgen::detail::mend(
      x > batch<T, A>(largest), kernel::expm1<A>(x, A{}), [](T a) { return std::expm1(a); }, x);
}
template <std::floating_point T, class A>
inline batch<T, A> log(const batch<T, A>& x) {
  using S = batch<T, A>;
  return physgen::detail::mend(
      x < S(std::numeric_limits<T>::min()), kernel::log<A>(x, A{}), [](T a) { return std::log(a); }, x);
}
template <std::floating_point T, class A>
inline batch<T, A> cbrt(const batch<T, A>& x) {
  using S = batch<T, A>;
  return physgen::detail::mend(
      abs(x) < S(std::numeric_limits<T>::min()), kernel::cbrt<A>(x, A{}), [](T a) { return std::cbrt(a); }, x);
}
template <std::floating_point T, class A>
inline batch<T, A> pow(const batch<T, A>& x, const batch<T, A>& y) {
  return physgen::detail::lane_by_lane(batch_bool<T, A>(true), x, [](T a, T b) { return std::pow(a, b); }, x, y);
}
template <std::floating_point T, class A>
inline batch<T, A> fmod(const batch<T, A>& x, const batch<T, A>& y) {
  return physgen::detail::lane_by_lane(batch_bool<T, A>(true), x, [](T a, T b) { return std::fmod(a, b); }, x, y);
}
/// Wrong where both are zero or infinite, and where the quotient is neither 0 nor a normal number.
template <std::floating_point T, class A>
inline batch<T, A> atan2(const batch<T, A>& y, const batch<T, A>& x) {
  using S = batch<T, A>;
  const S quotient = abs(y / x);
  const auto sound = quotient >= S(std::numeric_limits<T>::min()) && quotient <= S(std::numeric_limits<T>::max());
  return physgen::detail::mend(!sound, kernel::atan2<A>(y, x, A{}), [](T a, T b) { return std::atan2(a, b); }, y, x);
}
/// Wrong where a square over- or underflows.
template <std::floating_point T, class A>
inline batch<T, A> hypot(const batch<T, A>& x, const batch<T, A>& y) {
  using S = batch<T, A>;
  constexpr T large = sizeof(T) == 4 ? T(0x1p62) : T(0x1p510), small = sizeof(T) == 4 ? T(0x1p-50) : T(0x1p-480);
  const S longer = max(abs(x), abs(y));
  const auto sound = longer <= S(large) && longer >= S(small) && x == x && y == y;
  return physgen::detail::mend(!sound, sqrt(x * x + y * y), [](T a, T b) { return std::hypot(a, b); }, x, y);
}

}  // namespace xsimd

#pragma pop_macro("I")
