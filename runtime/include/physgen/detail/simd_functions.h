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

namespace xsimd::kernel::detail {

/// Takes a multiple of pi/2 off lanes x >= 0, for sin, cos and tan. xsimd's own of doubles takes one rounded word of pi
/// times the multiple off, which leaves nothing right of arguments next to it; and which one it takes depends on the
/// other lanes. Here are three words of 33 bits, whose multiples are exact, and their rests, as in the C library's
/// fdlibm.
template <class A>
struct trigo_reducer<batch<double, A>, trigo_radian_tag> {
  using S = batch<double, A>;

  /// @return which quarter x lies in, 0 to 3. @param rest what is left of x, within pi/4
  static S reduce(const S& x, S& rest) noexcept {
    if (all(x <= constants::pio4<S>())) {
      rest = x;
      return S(0.0);
    }
    const S quarters = nearbyint(x * constants::twoopi<S>());
    const S first = x - quarters * constants::pio2_1<S>();
    const S second = quarters * constants::pio2_2<S>(), less = first - second;
    const S third = quarters * constants::pio2_3<S>(), least = less - third;
    rest = least - (quarters * constants::pio2_3t<S>() - ((less - least) - third));
    const auto large = !(x <= constants::mediumpi<S>());  // and NaN
    if (any(large)) [[unlikely]]
      return of_large(large, x, quadrant(quarters), rest);
    return quadrant(quarters);
  }

 private:
  /// The same lane by lane, where `large` holds.
  [[gnu::noinline]] static S of_large(const batch_bool<double, A>& large, const S& x, const S& known,
                                      S& rest) noexcept {
    alignas(64) std::array<double, S::size> quarter, left;
    alignas(64) std::array<bool, S::size> is_large;
    known.store_aligned(quarter.data());
    rest.store_aligned(left.data());
    large.store_unaligned(is_large.data());
    for (std::size_t l = 0; l < S::size; ++l) {
      if (!is_large[l]) continue;
      const double of_lane = x.get(l);
      double words[2] = {of_lane - of_lane, 0};  // NaN where x is infinite or NaN
      quarter[l] = std::isfinite(of_lane) ? xsimd::detail::__ieee754_rem_pio2(of_lane, words) & 3 : 0;
      left[l] = words[0];
    }
    rest = S::load_aligned(left.data());
    return S::load_aligned(quarter.data());
  }
};

}  // namespace xsimd::kernel::detail

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
/// xsimd's own puts a double beside floats, which is refused (simd_numbers.h).
template <std::floating_point T, class A>
inline batch<T, A> round(const batch<T, A>& x) {
  using S = batch<T, A>;
  const S size = abs(x), above = ceil(size), nearest = select(above - S(T(0.5)) > size, above - S(T(1)), above);
  return select(size > constants::maxflint<S>(), x, copysign(nearest, x));
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
