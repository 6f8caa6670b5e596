// St Venant-Kirchhoff solid, psi = mu tr E^2 + lambda/2 (tr E)^2, E = (F^T F - 1) / 2: linear in the Green strain, a
// polynomial in s. It softens under compression and resists neither flattening nor inversion.
#pragma once

#include <fem/materials/material.h>

namespace physgen::fem {

template <class Real>
struct StVenantKirchhoff {
  using Scalar = Real;
  static constexpr const char* name = "St Venant-Kirchhoff";

  Real mu, lambda;  ///< Lame constants [Pa]

  /// @throws Error as lame_parameters() and constant_of() do
  static StVenantKirchhoff from(double youngs_modulus, double poissons_ratio) {
    const LameParameters lame = lame_parameters(youngs_modulus, poissons_ratio, name);
    return {constant_of<Real>(lame.mu, name, "mu"), constant_of<Real>(lame.lambda, name, "lambda", ConstantSign::Any)};
  }

  /// @return psi [J/m^3], without cancellation near rest
  /// Error <= 8 eps of |psi| + mu |s - 1|^2.
  template <class S>
  PHYSGEN_FUNCTION S energy(const Vector3<S>& s) const {
    const Vector3<S> q = twice_green_strain(s);
    const S trace = q[0] + q[1] + q[2];
    const S squares = fma(q[0], q[0], fma(q[1], q[1], q[2] * q[2]));
    return fma(S(mu / 4), squares, S(lambda / 8) * (trace * trace));
  }

  /// @return g = dpsi/ds [Pa]; zero at rest, with errors of a few eps of the strain near it
  /// Error <= 8 eps |H| |s|.
  template <class S>
  PHYSGEN_FUNCTION Vector3<S> stress(const Vector3<S>& s) const {
    const Vector3<S> q = twice_green_strain(s);
    const S m(mu), pressure = S(lambda / 2) * (q[0] + q[1] + q[2]);
    return {s[0] * fma(m, q[0], pressure), s[1] * fma(m, q[1], pressure), s[2] * fma(m, q[2], pressure)};
  }

  /// @return the 12 entries [Pa]. Error <= 8 eps of the largest.
  template <class S>
  PHYSGEN_FUNCTION PrincipalDerivative<S> derivative(const Vector3<S>& s) const {
    const S m(mu), l(lambda), stiff(3 * mu + lambda);
    const Vector3<S> q = twice_green_strain(s);
    const S t = fma(S(lambda / 2), q[0] + q[1] + q[2], -m);
    const S p1 = s[1] * s[2], p2 = s[0] * s[2], p3 = s[0] * s[1];
    const S a = s[0] * s[0], b = s[1] * s[1], c = s[2] * s[2];
    return {fma(stiff, a, t),
            l * p3,
            l * p2,
            fma(stiff, b, t),
            l * p1,
            fma(stiff, c, t),
            fma(m, a + b + p3, t),
            fma(m, a + c + p2, t),
            fma(m, b + c + p1, t),
            fma(m, a + b - p3, t),
            fma(m, a + c - p2, t),
            fma(m, b + c - p1, t)};
  }

 private:
  // s^2 - 1, rounded once.
  template <class S>
  PHYSGEN_FUNCTION static Vector3<S> twice_green_strain(const Vector3<S>& s) {
    const S minus_one(Real(-1));
    return {fma(s[0], s[0], minus_one), fma(s[1], s[1], minus_one), fma(s[2], s[2], minus_one)};
  }
};

}  // namespace physgen::fem
