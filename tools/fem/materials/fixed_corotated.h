// Fixed corotated solid (Stomakhin et al. 2012), psi = mu sum (s - 1)^2 + lambda/2 (J - 1)^2: finite for every s, with
// one pole in the derivative, where s_a + s_b = 0 and the rotation of F is not unique.
#pragma once

#include <fem/materials/material.h>

namespace physgen::fem {

/// S_ab = (g_a + g_b) / (s_a + s_b) contains -4 mu / (s_a + s_b). There |s_a + s_b| is held at or above
/// smallest_stretch_sum, so that |S_ab| <= 2 mu + 4 mu / smallest_stretch_sum + |lambda (J - 1) s_c|; elsewhere the
/// value is not changed.
template <class Real>
struct FixedCorotated {
  using Scalar = Real;
  static constexpr const char* name = "fixed corotated";
  static constexpr VolumeLaw volume_law = VolumeLaw::quadratic;

  Real mu, lambda;                         ///< Lame constants [Pa]
  Real smallest_stretch_sum = Real(1e-3);  ///< cap at the pole; any 1e-6 <= cap <= 1 [1]

  /// @throws Error as lame_parameters() and constant_of() do
  static FixedCorotated from(double youngs_modulus, double poissons_ratio) {
    const LameParameters lame = lame_parameters(youngs_modulus, poissons_ratio, name);
    return {constant_of<Real>(lame.mu, name, "mu"), constant_of<Real>(lame.lambda, name, "lambda", ConstantSign::Any)};
  }

  [[nodiscard]] Real& volume_modulus() { return lambda; }

  /// @return psi [J/m^3]
  /// Error <= 8 eps of |psi| + mu |s - 1|^2.
  template <class S>
  PHYSGEN_FUNCTION S energy(const Vector3<S>& s) const {
    const S one(Real(1)), half(Real(0.5));
    const S e1 = s[0] - one, e2 = s[1] - one, e3 = s[2] - one;
    const S change = detail::volume_change(detail::volume_ratio(s));
    return fma(S(mu), fma(e1, e1, fma(e2, e2, e3 * e3)), half * S(lambda) * (change * change));
  }

  /// @return g = dpsi/ds [Pa]
  /// Error <= 8 eps |H| |s|.
  template <class S>
  PHYSGEN_FUNCTION Vector3<S> stress(const Vector3<S>& s) const {
    const S one(Real(1)), m2(2 * mu);
    const S p = S(lambda) * detail::volume_change(detail::volume_ratio(s));
    return {fma(m2, s[0] - one, p * (s[1] * s[2])), fma(m2, s[1] - one, p * (s[0] * s[2])),
            fma(m2, s[2] - one, p * (s[0] * s[1]))};
  }

  /// @return the 12 entries [Pa]. Error <= 8 eps of the largest.
  template <class S>
  PHYSGEN_FUNCTION PrincipalDerivative<S> derivative(const Vector3<S>& s) const {
    const S l(lambda), m2(2 * mu), smallest(smallest_stretch_sum);
    const TwoPart<S> J = detail::volume_ratio(s);
    const S change = detail::volume_change(J);
    const S p = l * change;                 // lambda (J - 1)
    const S mixed = l * (J.head + change);  // lambda (2 J - 1)
    const S c1 = s[1] * s[2], c2 = s[0] * s[2], c3 = s[0] * s[1];
    return {fma(l * c1, c1, m2),
            mixed * s[2],
            mixed * s[1],
            fma(l * c2, c2, m2),
            mixed * s[0],
            fma(l * c3, c3, m2),
            fma(-p, s[2], m2),
            fma(-p, s[1], m2),
            fma(-p, s[0], m2),
            fma(p, s[2], turning(detail::held_stretch_sum(s[0], s[1], smallest))),
            fma(p, s[1], turning(detail::held_stretch_sum(s[0], s[2], smallest))),
            fma(p, s[0], turning(detail::held_stretch_sum(s[1], s[2], smallest)))};
  }

 private:
  // 2 mu - 4 mu / (s_a + s_b), which vanishes at rest.
  template <class S>
  PHYSGEN_FUNCTION S turning(const S& sum) const {
    return S(2 * mu) * ((sum - S(Real(2))) / sum);
  }
};

}  // namespace physgen::fem
