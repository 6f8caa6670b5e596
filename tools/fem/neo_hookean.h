// Compressible Neo-Hookean solid, psi = mu/2 (I1 - 3) - mu ln J + lambda/2 ln^2 J, continued below a small J so that
// flattened and inverted elements have finite forces that push them back.
#pragma once

#include <fem/material.h>

namespace physgen::fem {

/// Write psi = mu/2 (I1 - 3) + phi(J), phi = -mu ln J + lambda/2 ln^2 J. Below J0 = smallest_volume_ratio, phi' goes on
/// linearly: phi(J) = phi(J0) + phi'(J0) (J - J0) + phi''(J0)/2 (J - J0)^2. So there is an energy everywhere, the
/// stress is continuously differentiable in s across J0 and across inversion, and the pole at s -> 0 is gone.
template <class Real>
struct NeoHookean {
  using Scalar = Real;
  static constexpr const char* name = "Neo-Hookean";

  Real mu, lambda;                          ///< Lame constants [Pa]
  Real smallest_volume_ratio = Real(0.25);  ///< J0, 0 < J0 < 1

  /// @throws Error as lame_parameters() does
  static NeoHookean from(double youngs_modulus, double poissons_ratio) {
    const LameParameters lame = lame_parameters(youngs_modulus, poissons_ratio, name);
    return {Real(lame.mu), Real(lame.lambda)};
  }

  /// @return psi [J/m^3], without cancellation near rest
  template <class S>
  PHYSGEN_FUNCTION S energy(const Vector3<S>& s) const {
    const S one(Real(1)), half(Real(0.5)), m(mu);
    const Volume<S> v = volume(s);
    // I1 - 3 - 2 ln J = sum e^2 + 2 (e1 + e2 + e3 - (J - 1)) + 2 (J - 1 - ln J); the middle term is -2 times the sum
    // of the products of different e.
    const S e1 = s[0] - one, e2 = s[1] - one, e3 = s[2] - one;
    const S squares = fma(e1, e1, fma(e2, e2, e3 * e3));
    const S products = fma(e1, e2, fma(e1, e3, e2 * e3)) + e1 * e2 * e3;
    const S beyond = v.change - v.held;  // J - J0 below J0, else 0
    const S log_energy = fma(half * S(lambda), v.log * v.log, m * difference_to_log(v.held, v.log));
    return fma(m, fma(half, squares, -products), log_energy) + beyond * fma(half * v.curvature, beyond, v.held_slope);
  }

  /// @return g = dpsi/ds [Pa]; zero at rest, with errors of a few eps of the strain near it
  template <class S>
  PHYSGEN_FUNCTION Vector3<S> stress(const Vector3<S>& s) const {
    using detail::stretch_minus_cofactor;
    const S m(mu);
    const S w = volume(s).slope;
    return {fma(m, stretch_minus_cofactor(s[0], s[1], s[2]), w * (s[1] * s[2])),
            fma(m, stretch_minus_cofactor(s[1], s[0], s[2]), w * (s[0] * s[2])),
            fma(m, stretch_minus_cofactor(s[2], s[0], s[1]), w * (s[0] * s[1]))};
  }

  template <class S>
  PHYSGEN_FUNCTION PrincipalDerivative<S> derivative(const Vector3<S>& s) const {
    const S m(mu);
    const Volume<S> v = volume(s);
    const S k = v.curvature, w = v.slope - m;  // phi'' and phi'
    const S c1 = s[1] * s[2], c2 = s[0] * s[2], c3 = s[0] * s[1];
    const S k1 = k * c1, k2 = k * c2;
    const S w1 = w * s[0], w2 = w * s[1], w3 = w * s[2];
    return {fma(k1, c1, m), fma(k1, c2, w3), fma(k1, c3, w2), fma(k2, c2, m), fma(k2, c3, w1), fma(k * c3, c3, m),
            m - w3,         m - w2,          m - w1,          m + w3,         m + w2,          m + w1};
  }

 private:
  template <class S>
  struct Volume {
    S change;      // J - 1
    S held;        // max(J, J0) - 1
    S log;         // ln max(J, J0)
    S held_slope;  // phi'(max(J, J0)) + mu
    S slope;       // phi'(J) + mu: with the mu, it vanishes at rest
    S curvature;   // phi''(J)
  };

  template <class S>
  PHYSGEN_FUNCTION Volume<S> volume(const Vector3<S>& s) const {
    const S one(Real(1)), m(mu), l(lambda);
    const S change = detail::volume_change(s);
    const S held = max(change, S(smallest_volume_ratio) - one);
    const S log_held = log1p(held);
    // Not 1 / (1 + held): away from rest the product has the smaller relative error.
    const S inverse = one / max(s[0] * s[1] * s[2], S(smallest_volume_ratio));
    const S held_slope = fma(m, held, l * log_held) * inverse;
    const S curvature = fma(-l, log_held, m + l) * (inverse * inverse);
    return {change, held, log_held, held_slope, fma(curvature, change - held, held_slope), curvature};
  }

  // x - ln(1 + x), given both. Near zero from the series of ln(1 + x) = 2 artanh(x / (2 + x)).
  template <class S>
  PHYSGEN_FUNCTION static S difference_to_log(const S& x, const S& log_of_1_plus_x) {
    const S r = x / (x + S(Real(2)));
    const S q = r * r;
    S series(Real(1) / Real(21));
    PHYSGEN_UNROLL
    for (int odd = 19; odd >= 3; odd -= 2) series = fma(series, q, S(Real(1) / Real(odd)));
    const S near = r * (x - S(Real(2)) * q * series);
    return select(abs(x) < S(Real(0.3)), near, x - log_of_1_plus_x);
  }
};

}  // namespace physgen::fem
