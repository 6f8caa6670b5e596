// Stable Neo-Hookean solid (Smith, de Goes and Kim 2018) with its logarithmic term, psi = mu/2 (I1 - 3) +
// lambda/2 (J - alpha)^2 - mu/2 ln(I1 + 1), alpha = 1 + 3/4 mu / lambda: finite and smooth for every s, and stiff
// against collapse to a point.
#pragma once

#include <fem/materials/shear_and_volume.h>

namespace physgen::fem {

/// Evaluated as mu/2 (I1 - 3) - 3/4 mu (J - 1) + lambda/2 (J - 1)^2 - mu/2 ln((I1 + 1) / 4), which differs by a
/// constant, is 0 at rest and needs no lambda > 0. mu and lambda are the model's own constants; with 4/3 mu and
/// lambda + 5/6 mu of Lame's for them, the tangent at rest is that of linear elasticity.
template <class Real>
struct StableNeoHookeanFull {
  using Scalar = Real;
  static constexpr const char* name = "stable Neo-Hookean, full";

  Real mu, lambda;  ///< the model's constants [Pa]

  /// @throws Error as lame_parameters() and constant_of() do
  static StableNeoHookeanFull from(double youngs_modulus, double poissons_ratio) {
    const LameParameters lame = lame_parameters(youngs_modulus, poissons_ratio, name);
    return {constant_of<Real>(4 * lame.mu / 3, name, "mu"),
            constant_of<Real>(lame.lambda + 5 * lame.mu / 6, name, "lambda")};
  }

  /// @return psi [J/m^3], without cancellation near rest: the terms of first order are taken together,
  /// 3/4 mu ((I1 - 3)/2 - (J - 1)) + lambda/2 (J - 1)^2 + mu/2 (x - ln(1 + x)), x = (I1 - 3) / 4.
  /// Error <= 8 eps of |psi| + mu |s - 1|^2.
  template <class S>
  PHYSGEN_FUNCTION S energy(const Vector3<S>& s) const {
    const S one(Real(1)), half(Real(0.5)), m(mu);
    const S change = detail::volume_change(detail::volume_ratio(s));
    const S quarter = S(Real(0.25)) * detail::stretch_change(s);
    const S logarithmic = detail::difference_to_log(quarter, log_two_part<S>(one + quarter, S(Real(0))));
    return fma(half * m, logarithmic,
               fma(S(Real(0.75)) * m, detail::half_stretch_beyond_volume(s), half * S(lambda) * (change * change)));
  }

  /// @return g = dpsi/ds [Pa]; zero at rest, with errors of a few eps of the strain near it
  /// Error <= 8 eps |H| |s|.
  template <class S>
  PHYSGEN_FUNCTION Vector3<S> stress(const Vector3<S>& s) const {
    const Shear<S> k = shear(s);
    const S change = detail::volume_change(detail::volume_ratio(s));
    // m + w = lambda (J - 1) + mu (1/4 - 1 / (I1 + 1)), the latter as mu (I1 - 3) / (4 (I1 + 1))
    const S from_rest = fma(S(lambda), change, S(mu / 4) * (detail::stretch_change(s) * k.inverse));
    return detail::shear_and_volume_stress(k.modulus, from_rest, s);
  }

  /// @return the 12 entries [Pa]. Error <= 8 eps of the largest.
  template <class S>
  PHYSGEN_FUNCTION PrincipalDerivative<S> derivative(const Vector3<S>& s) const {
    const S l(lambda), m(Real(0.75) * mu);
    const Shear<S> k = shear(s);
    const TwoPart<S> J = detail::volume_ratio(s);
    const S change = detail::volume_change(J);
    const detail::VolumeTerm<S> volume{fma(l, change, -m), l, fma(l, J.head + change, -m)};
    PrincipalDerivative<S> d = detail::shear_and_volume_derivative(k.modulus, volume, s);
    // 2 mu / (I1 + 1)^2 s_a s_b, from the change of the modulus with I1.
    const S slope = S(2 * mu) * (k.inverse * k.inverse);
    const S t1 = slope * s[0], t2 = slope * s[1], t3 = slope * s[2];
    d.h11 = fma(t1, s[0], d.h11);
    d.h21 = fma(t1, s[1], d.h21);
    d.h31 = fma(t1, s[2], d.h31);
    d.h22 = fma(t2, s[1], d.h22);
    d.h32 = fma(t2, s[2], d.h32);
    d.h33 = fma(t3, s[2], d.h33);
    return d;
  }

 private:
  template <class S>
  struct Shear {
    S inverse;  // 1 / (I1 + 1)
    S modulus;  // mu I1 / (I1 + 1)
  };
  template <class S>
  PHYSGEN_FUNCTION Shear<S> shear(const Vector3<S>& s) const {
    const S one(Real(1));
    const S I1 = fma(s[0], s[0], fma(s[1], s[1], s[2] * s[2]));
    const S inverse = one / (I1 + one);
    return {inverse, S(mu) * (I1 * inverse)};
  }
};

}  // namespace physgen::fem
