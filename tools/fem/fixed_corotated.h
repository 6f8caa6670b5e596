// Fixed corotated solid (Stomakhin et al. 2012), psi = mu sum (s - 1)^2 + lambda/2 (J - 1)^2: finite for every s, with
// one pole in the derivative, where s_a + s_b = 0 and the rotation of F is not unique.
#pragma once

#include <fem/material.h>

namespace physgen::fem {

/// S_ab = (g_a + g_b) / (s_a + s_b) contains -4 mu / (s_a + s_b). There |s_a + s_b| is held at or above
/// smallest_stretch_sum, so entries stay below 4 mu / smallest_stretch_sum; elsewhere the value is exact.
template <class Real>
struct FixedCorotated {
  using Scalar = Real;
  static constexpr const char* name = "fixed corotated";

  Real mu, lambda;                         ///< Lame constants [Pa]
  Real smallest_stretch_sum = Real(1e-3);  ///< cap at the pole, > 0

  /// @throws Error as lame_parameters() does
  static FixedCorotated from(double youngs_modulus, double poissons_ratio) {
    const LameParameters lame = lame_parameters(youngs_modulus, poissons_ratio, name);
    return {Real(lame.mu), Real(lame.lambda)};
  }

  /// @return psi [J/m^3]
  template <class S>
  PHYSGEN_FUNCTION S energy(const Vector3<S>& s) const {
    const S one(Real(1)), half(Real(0.5));
    const S e1 = s[0] - one, e2 = s[1] - one, e3 = s[2] - one;
    const S change = detail::volume_change(s);
    return fma(S(mu), fma(e1, e1, fma(e2, e2, e3 * e3)), half * S(lambda) * (change * change));
  }

  /// @return g = dpsi/ds [Pa]
  template <class S>
  PHYSGEN_FUNCTION Vector3<S> stress(const Vector3<S>& s) const {
    const S one(Real(1)), m2(2 * mu);
    const S p = S(lambda) * detail::volume_change(s);
    return {fma(m2, s[0] - one, p * (s[1] * s[2])), fma(m2, s[1] - one, p * (s[0] * s[2])),
            fma(m2, s[2] - one, p * (s[0] * s[1]))};
  }

  template <class S>
  PHYSGEN_FUNCTION PrincipalDerivative<S> derivative(const Vector3<S>& s) const {
    const S l(lambda), m2(2 * mu);
    const S change = detail::volume_change(s);
    const S p = l * change;                                    // lambda (J - 1)
    const S mixed = fma(l, change, l * (s[0] * s[1] * s[2]));  // lambda (2 J - 1)
    const S c1 = s[1] * s[2], c2 = s[0] * s[2], c3 = s[0] * s[1];
    const S p1 = p * s[0], p2 = p * s[1], p3 = p * s[2];
    return {fma(l * c1, c1, m2),
            mixed * s[2],
            mixed * s[1],
            fma(l * c2, c2, m2),
            mixed * s[0],
            fma(l * c3, c3, m2),
            m2 - p3,
            m2 - p2,
            m2 - p1,
            turning(s[0] + s[1]) + p3,
            turning(s[0] + s[2]) + p2,
            turning(s[1] + s[2]) + p1};
  }

 private:
  // 2 mu - 4 mu / (s_a + s_b), capped at the pole.
  template <class S>
  PHYSGEN_FUNCTION S turning(const S& sum) const {
    const S m2(2 * mu), two(Real(2));
    const S held = copysign(max(abs(sum), S(smallest_stretch_sum)), sum);
    return m2 * ((held - two) / held);
  }
};

}  // namespace physgen::fem
