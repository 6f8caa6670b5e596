// Quadruple precision for references: 113 significant bits from the compiler, and the functions it brings none of.
// Host only.
#pragma once

#include <cmath>

namespace physgen::fem::reference {

/// 113 significant bits; from the compiler, so no library is needed.
__extension__ using Quad = __float128;

/// e^x, from its series after halvings of x.
inline Quad exp(Quad x) {
  int halvings = 0;
  for (; x > 0.01 || x < -0.01; ++halvings) x /= 2;
  Quad term = 1, sum = 1;
  for (int n = 1; n < 20; ++n) sum += term *= x / n;
  for (; halvings > 0; --halvings) sum *= sum;
  return sum;
}

namespace detail {
/// 2 artanh(s), |s| <= 1/3: its series, s (2 + 2/3 s^2 + 2/5 s^4 + ...)
inline Quad twice_artanh(Quad s) {
  const Quad q = s * s;
  Quad sum = 0;
  for (int odd = 71; odd >= 1; odd -= 2) sum = sum * q + Quad(2) / odd;
  return s * sum;
}
}  // namespace detail

/// Natural logarithm of x > 0 within the range of double, also next to 1: from x = m 2^k, sqrt(1/2) <= m < sqrt(2).
inline Quad log(Quad x) {
  static const Quad ln2 = detail::twice_artanh(Quad(1) / 3);
  int k = std::ilogb(static_cast<double>(x));
  Quad m = x / std::ldexp(1., k);
  if (m > 1.4142135) m /= 2, ++k;
  return k * ln2 + detail::twice_artanh((m - 1) / (m + 1));
}

/// x^power of x > 0.
inline Quad pow(Quad x, Quad power) { return exp(power * log(x)); }

inline Quad abs(Quad x) { return x < 0 ? -x : x; }

}  // namespace physgen::fem::reference
