// The energies of all materials, written out as in the books, in quadruple precision and with derivatives: the oracle
// of stress and stress derivative. Nothing is shared with the models but the names of their constants. Host only.
#pragma once

#include <fem/materials/materials.h>
#include <fem/reference/jet.h>

namespace physgen::fem::reference {

using Stretches = std::array<Jet, 3>;

namespace detail {

inline Jet volume(const Stretches& s) { return s[0] * s[1] * s[2]; }
inline Jet square(const Jet& x) { return x * x; }
/// sum s^2
inline Jet squares(const Stretches& s) { return square(s[0]) + square(s[1]) + square(s[2]); }
/// sum s^4
inline Jet fourth_powers(const Stretches& s) {
  return square(square(s[0])) + square(square(s[1])) + square(square(s[2]));
}
/// sum (s - 1)
inline Jet strains(const Stretches& s) { return s[0] + s[1] + s[2] - Jet(3.); }
/// sum (s - 1)^2
inline Jet squared_strains(const Stretches& s) {
  return square(s[0] - Jet(1.)) + square(s[1] - Jet(1.)) + square(s[2] - Jet(1.));
}

/// f(J), and below J0 its quadratic Taylor polynomial at J0.
template <class Function>
Jet continued(const Jet& J, Quad J0, const Function& f) {
  if (J.value >= J0) return f(J);
  Jet at{J0};
  at.gradient[0] = 1;
  const Jet t = f(at);
  const Jet d = J - Jet(J0);
  return Jet(t.value) + Jet(t.gradient[0]) * d + Jet(t.hessian[0][0] / 2) * d * d;
}

}  // namespace detail

/// psi(s) [J/m^3] with its first two derivatives.
template <class R>
Jet energy(const NeoHookean<R>& m, const Stretches& s) {
  const Quad mu = m.mu, lambda = m.lambda;
  return Jet(mu / 2) * (detail::squares(s) - Jet(3.)) +
         detail::continued(detail::volume(s), Quad(m.smallest_volume_ratio), [&](const Jet& J) {
           const Jet L = log(J);
           return Jet(lambda / 2) * L * L - Jet(mu) * L;
         });
}

template <class R>
Jet energy(const StVenantKirchhoff<R>& m, const Stretches& s) {
  const Quad mu = m.mu, lambda = m.lambda;
  const auto green = [&s](std::size_t a) { return (detail::square(s[a]) - Jet(1.)) * Jet(0.5); };
  return Jet(mu) * (detail::square(green(0)) + detail::square(green(1)) + detail::square(green(2))) +
         Jet(lambda / 2) * detail::square(green(0) + green(1) + green(2));
}

template <class R>
Jet energy(const Corotated<R>& m, const Stretches& s) {
  return Jet(Quad(m.mu)) * detail::squared_strains(s) + Jet(Quad(m.lambda) / 2) * detail::square(detail::strains(s));
}

template <class R>
Jet energy(const FixedCorotated<R>& m, const Stretches& s) {
  return Jet(Quad(m.mu)) * detail::squared_strains(s) +
         Jet(Quad(m.lambda) / 2) * detail::square(detail::volume(s) - Jet(1.));
}

/// Smith et al. 2018, without the logarithm; less its value at rest.
template <class R>
Jet energy(const StableNeoHookean<R>& m, const Stretches& s) {
  const Quad mu = m.mu, lambda = m.lambda, alpha = 1 + mu / lambda;
  return Jet(mu / 2) * (detail::squares(s) - Jet(3.)) +
         Jet(lambda / 2) * (detail::square(detail::volume(s) - Jet(alpha)) - Jet((1 - alpha) * (1 - alpha)));
}

/// Smith et al. 2018; less its value at rest.
template <class R>
Jet energy(const StableNeoHookeanFull<R>& m, const Stretches& s) {
  const Quad mu = m.mu, lambda = m.lambda, alpha = 1 + mu / lambda - mu / (4 * lambda);
  const Jet I1 = detail::squares(s);
  return Jet(mu / 2) * (I1 - Jet(3.)) +
         Jet(lambda / 2) * (detail::square(detail::volume(s) - Jet(alpha)) - Jet((1 - alpha) * (1 - alpha))) -
         Jet(mu / 2) * (log(I1 + Jet(1.)) - Jet(log(Quad(4))));
}

template <class R>
Jet energy(const MooneyRivlin<R>& m, const Stretches& s) {
  const Quad J0 = m.smallest_volume_ratio, third = Quad(1) / 3;
  const Jet J = detail::volume(s), I1 = detail::squares(s);
  const Jet I2 = Jet(0.5) * (I1 * I1 - detail::fourth_powers(s));
  const Jet a = detail::continued(J, J0, [&](const Jet& x) { return pow(x, -2 * third); });
  const Jet b = detail::continued(J, J0, [&](const Jet& x) { return pow(x, -4 * third); });
  const Jet c = detail::continued(J, J0, [](const Jet& x) { return log(x) * log(x); });
  return Jet(Quad(m.m10)) * (a * I1 - Jet(3.)) + Jet(Quad(m.m01)) * (b * I2 - Jet(3.)) + Jet(Quad(m.kappa) / 2) * c;
}

}  // namespace physgen::fem::reference
