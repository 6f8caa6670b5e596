// Compressible Neo-Hookean solid, psi = mu/2 (I1 - 3) - mu ln J + lambda/2 ln^2 J, continued below a small J so that
// flattened and inverted elements have finite forces that push them back.
#pragma once

#include <fem/materials/shear_and_volume.h>

namespace physgen::fem {

/// Write psi = mu/2 (I1 - 3) + phi(J), phi = -mu ln J + lambda/2 ln^2 J. Below J0 = smallest_volume_ratio, phi' goes on
/// linearly: phi(J) = phi(J0) + phi'(J0) (J - J0) + phi''(J0)/2 (J - J0)^2. So there is an energy everywhere, the
/// stress is continuously differentiable in s across J0 and across inversion, and the pole at s -> 0 is gone.
template <class Real>
struct NeoHookean {
  using Scalar = Real;
  static constexpr const char* name = "Neo-Hookean";
  static constexpr VolumeLaw volume_law = VolumeLaw::logarithmic;

  Real mu, lambda;                          ///< Lame constants [Pa]
  Real smallest_volume_ratio = Real(0.25);  ///< J0; any 0.01 <= J0 <= 0.5 [1]

  /// @throws Error as lame_parameters() and constant_of() do
  static NeoHookean from(double youngs_modulus, double poissons_ratio) {
    const LameParameters lame = lame_parameters(youngs_modulus, poissons_ratio, name);
    return {constant_of<Real>(lame.mu, name, "mu"), constant_of<Real>(lame.lambda, name, "lambda", ConstantSign::Any)};
  }

  [[nodiscard]] Real& volume_modulus() { return lambda; }

  /// @return psi [J/m^3], without cancellation near rest
  /// Error <= 8 eps of |psi| + mu |s - 1|^2.
  template <class S>
  PHYSGEN_FUNCTION S energy(const Vector3<S>& s) const {
    const S half(Real(0.5)), m(mu), l(lambda);
    const auto J = detail::hold(detail::volume_ratio(s), S(smallest_volume_ratio));
    const TwoPart<S> log = log_two_part(J.held.head, J.held.tail);
    const S change = detail::volume_change(J.held);
    const Volume<S> held = volume(J.held, S(Real(0)));
    const S log_energy = fma(half * l, log.head * log.head, m * detail::difference_to_log(change, log));
    const S beyond = J.beyond * fma(half * held.term.curvature, J.beyond, held.slope_from_rest);
    return fma(m, detail::half_stretch_beyond_volume(s), log_energy + beyond);
  }

  /// @return g = dpsi/ds [Pa]; zero at rest, with errors of a few eps of the strain near it
  /// Error <= 8 eps |H| |s|.
  template <class S>
  PHYSGEN_FUNCTION Vector3<S> stress(const Vector3<S>& s) const {
    return detail::shear_and_volume_stress(S(mu), volume(s).slope_from_rest, s);
  }

  /// @return the 12 entries [Pa]. Error <= 8 eps of the largest.
  template <class S>
  PHYSGEN_FUNCTION PrincipalDerivative<S> derivative(const Vector3<S>& s) const {
    return detail::shear_and_volume_derivative(S(mu), volume(s).term, s);
  }

 private:
  template <class S>
  struct Volume {
    detail::VolumeTerm<S> term;
    S slope_from_rest;  // phi' + mu [Pa]
  };

  template <class S>
  PHYSGEN_FUNCTION Volume<S> volume(const Vector3<S>& s) const {
    const auto J = detail::hold(detail::volume_ratio(s), S(smallest_volume_ratio));
    return volume(J.held, J.beyond);
  }

  // phi at J >= J0 in two parts, then continued by `beyond`. With L = ln J in two parts, lambda (1 - L) + mu keeps its
  // digits where it vanishes, near ln J = 1 + mu / lambda; and phi'' J + phi' = lambda / J needs no logarithm at all.
  template <class S>
  PHYSGEN_FUNCTION Volume<S> volume(const TwoPart<S>& J, const S& beyond) const {
    const S one(Real(1)), two(Real(2)), m(mu), l(lambda);
    const TwoPart<S> log = log_two_part(J.head, J.tail);
    const S inverse = one / J.head;
    const S change = detail::volume_change(J);
    const S curvature = fma(l, (one - log.head) - log.tail, m) * (inverse * inverse);
    return {
        {fma(curvature, beyond, fma(l, log.head, -m) * inverse), curvature, fma(two * curvature, beyond, l * inverse)},
        fma(curvature, beyond, fma(m, change, l * log.head) * inverse)};
  }
};

}  // namespace physgen::fem
