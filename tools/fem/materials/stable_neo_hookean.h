// Stable Neo-Hookean solid (Smith, de Goes and Kim 2018) without its logarithmic term, psi = mu/2 (I1 - 3) +
// lambda/2 (J - alpha)^2, alpha = 1 + mu / lambda: a polynomial, finite and smooth for every s.
#pragma once

#include <fem/materials/shear_and_volume.h>

namespace physgen::fem {

/// Evaluated as mu/2 (I1 - 3) - mu (J - 1) + lambda/2 (J - 1)^2, which differs by a constant, is 0 at rest and needs no
/// lambda > 0. mu and lambda are the model's own constants; with Lame's mu and lambda + mu for them, the tangent at
/// rest is that of linear elasticity.
template <class Real>
struct StableNeoHookean {
  using Scalar = Real;
  static constexpr const char* name = "stable Neo-Hookean, short";
  static constexpr VolumeLaw volume_law = VolumeLaw::quadratic;

  Real mu, lambda;  ///< the model's constants [Pa]

  /// @throws Error as lame_parameters() and constant_of() do
  static StableNeoHookean from(double youngs_modulus, double poissons_ratio) {
    const LameParameters lame = lame_parameters(youngs_modulus, poissons_ratio, name);
    return {constant_of<Real>(lame.mu, name, "mu"), constant_of<Real>(lame.lambda + lame.mu, name, "lambda")};
  }

  [[nodiscard]] Real& volume_modulus() { return lambda; }

  /// @return psi [J/m^3], without cancellation near rest
  /// Error <= 8 eps of |psi| + mu |s - 1|^2.
  template <class S>
  PHYSGEN_FUNCTION S energy(const Vector3<S>& s) const {
    const S half(Real(0.5));
    const S change = detail::volume_change(detail::volume_ratio(s));
    return fma(S(mu), detail::half_stretch_beyond_volume(s), half * S(lambda) * (change * change));
  }

  /// @return g = dpsi/ds [Pa]; zero at rest, with errors of a few eps of the strain near it
  /// Error <= 8 eps |H| |s|.
  template <class S>
  PHYSGEN_FUNCTION Vector3<S> stress(const Vector3<S>& s) const {
    return detail::shear_and_volume_stress<S>(S(mu), S(lambda) * detail::volume_change(detail::volume_ratio(s)), s);
  }

  /// @return the 12 entries [Pa]. Error <= 8 eps of the largest.
  template <class S>
  PHYSGEN_FUNCTION PrincipalDerivative<S> derivative(const Vector3<S>& s) const {
    const S m(mu), l(lambda);
    const TwoPart<S> J = detail::volume_ratio(s);
    const S change = detail::volume_change(J);
    const detail::VolumeTerm<S> volume{fma(l, change, -m), l, fma(l, J.head + change, -m)};
    return detail::shear_and_volume_derivative(m, volume, s);
  }
};

}  // namespace physgen::fem
