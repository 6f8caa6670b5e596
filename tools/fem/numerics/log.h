// Natural logarithm to more digits than the scalar type has, from one source for numbers, packs and CUDA, so that all
// of them agree: where stress or stiffness is a small rest of it, the rest still has its digits.
#pragma once

#include <fem/numerics/two_part.h>

namespace physgen::fem {

namespace detail {

/// ln 2 in two parts, the first with so few bits that an exponent times it is exact (after fdlibm's e_logf.c, e_log.c),
/// and how many terms of the series 2 artanh(s) = 2 s + s (2/3 s^2 + 2/5 s^4 + ...) leave out less than 0.02 eps at the
/// largest s = 3 - 2 sqrt(2): the first term left out is s^(2 n) / (2 n + 1) of the whole.
template <class Real>
struct LogConstants;
template <>
struct LogConstants<float> {
  static constexpr float ln2_high = 0x1.62e300p-1f, ln2_low = 0x1.2fefa2p-17f;
  static constexpr int terms = 4;
};
template <>
struct LogConstants<double> {
  static constexpr double ln2_high = 0x1.62e42fee00000p-1, ln2_low = 0x1.a39ef35793c76p-33;
  static constexpr int terms = 10;
};

}  // namespace detail

/// @param x a normal number > 0; NaN and infinity give NaN
/// @param x_tail what x lacks: |x_tail| <= eps x
/// @return ln(x + x_tail), error <= 1/4 eps |ln x| + 2 eps |x_tail / x|, also next to x = 1, where ln x vanishes
/// (measured: 0.14 eps |ln x|, half of the bound with a tail). x_tail enters as x_tail / x; what its square changes is
/// left out.
///
/// With x = m 2^k, f = m - 1 and s = f / (2 + f): ln x = k ln 2 + f - f^2/2 + s (f^2/2 + R), R = 2/3 s^2 + 2/5 s^4 +
/// ... The first three terms are summed without error; the rest is small, so its own rounding hardly counts.
template <class S>
PHYSGEN_FUNCTION inline TwoPart<S> log_two_part(const S& x, const S& x_tail) {
  using Real = RealOf<S>;
  using Constants = detail::LogConstants<Real>;
  const S one(Real(1)), two(Real(2)), half(Real(0.5)), zero(Real(0));
  const auto split = math::ScalarTraits<S>::split(x);
  const S f = split.mantissa - one, k = split.exponent;
  const S s = f / (two + f);
  const S q = s * s;
  S series(Real(2) / Real(2 * Constants::terms + 1));
  PHYSGEN_UNROLL
  for (int n = Constants::terms - 1; n >= 1; --n) series = fma(series, q, S(Real(2) / Real(2 * n + 1)));
  const TwoPart<S> square = two_product<S>(half * f, f);
  const TwoPart<S> linear = fast_two_sum<S>(k * S(Constants::ln2_high), f);
  const TwoPart<S> quadratic = fast_two_sum<S>(linear.head, -square.head);
  S rest = s * fma(series, q, square.head);
  rest = fma(k, S(Constants::ln2_low), rest);
  rest = rest + (quadratic.tail + (linear.tail - square.tail));
  rest = fma(x_tail, one / x, rest);
  rest = fma(zero, x, rest);  // NaN of NaN and infinity, of which split() makes ordinary numbers
  return fast_two_sum(quadratic.head, rest);
}

}  // namespace physgen::fem
