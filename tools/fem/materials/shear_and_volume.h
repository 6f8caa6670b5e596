// The common part of the models psi = mu/2 (I1 - 3) + phi(J) (Neo-Hookean and the stable ones): stress and derivative
// from mu and the derivatives of phi, and the energy without cancellation near rest.
#pragma once

#include <fem/materials/material.h>

namespace physgen::fem::detail {

/// phi(J) of such a model. At rest phi'(1) = -mu, so that there is no stress.
template <class S>
struct VolumeTerm {
  S slope;      ///< phi'(J) [Pa]
  S curvature;  ///< phi''(J) [Pa]
  S mixed;      ///< phi''(J) J + phi'(J) [Pa], so that H_ab = mixed s_c
};

/// @param shear mu; where it is a function of I1, 2 dpsi/dI1 [Pa]
/// @param slope_from_rest phi'(J) + mu [Pa], found without that sum: it vanishes at rest
/// @return g_a = mu s_a + phi' s_b s_c [Pa], as mu (s_a - s_b s_c) + (phi' + mu) s_b s_c: both terms vanish at rest,
/// and the first is rounded once only.
template <class S>
PHYSGEN_FUNCTION inline Vector3<S> shear_and_volume_stress(const S& shear, const S& slope_from_rest,
                                                           const Vector3<S>& s) {
  return {fma(shear, fma(-s[1], s[2], s[0]), slope_from_rest * (s[1] * s[2])),
          fma(shear, fma(-s[0], s[2], s[1]), slope_from_rest * (s[0] * s[2])),
          fma(shear, fma(-s[0], s[1], s[2]), slope_from_rest * (s[0] * s[1]))};
}

/// @return H_aa = mu + phi'' (s_b s_c)^2, H_ab = (phi'' J + phi') s_c, D = mu - phi' s_c, S = mu + phi' s_c [Pa]
template <class S>
PHYSGEN_FUNCTION inline PrincipalDerivative<S> shear_and_volume_derivative(const S& shear, const VolumeTerm<S>& volume,
                                                                           const Vector3<S>& s) {
  const S c1 = s[1] * s[2], c2 = s[0] * s[2], c3 = s[0] * s[1];
  const S &k = volume.curvature, &w = volume.slope;
  return {fma(k * c1, c1, shear), volume.mixed * s[2],    volume.mixed * s[1],  fma(k * c2, c2, shear),
          volume.mixed * s[0],    fma(k * c3, c3, shear), fma(-w, s[2], shear), fma(-w, s[1], shear),
          fma(-w, s[0], shear),   fma(w, s[2], shear),    fma(w, s[1], shear),  fma(w, s[0], shear)};
}

/// (I1 - 3) / 2 - (J - 1), of second order near rest. With e = s - 1 it is half the sum of the e^2 less the products of
/// different e; the first order, which would cancel, is not there.
template <class S>
PHYSGEN_FUNCTION inline S half_stretch_beyond_volume(const Vector3<S>& s) {
  const S one(RealOf<S>(1)), half(RealOf<S>(0.5));
  const S e1 = s[0] - one, e2 = s[1] - one, e3 = s[2] - one;
  const S squares = fma(e1, e1, fma(e2, e2, e3 * e3));
  const S products = fma(e1, e2, fma(e1, e3, e2 * e3));
  return fma(-(e1 * e2), e3, fma(half, squares, -products));
}

/// x - ln(1 + x), given both: of second order near x = 0, where it comes from the series ln(1 + x) = 2 artanh(r),
/// r = x / (2 + x), whose first term it cancels exactly.
template <class S>
PHYSGEN_FUNCTION inline S difference_to_log(const S& x, const TwoPart<S>& log) {
  using Real = RealOf<S>;
  const S two(Real(2));
  const S r = x / (x + two);
  const S q = r * r;
  S series(Real(1) / Real(21));
  PHYSGEN_UNROLL
  for (int odd = 19; odd >= 3; odd -= 2) series = fma(series, q, S(Real(1) / Real(odd)));
  const S near = r * fma(-two * q, series, x);
  return select(abs(x) < S(Real(0.3)), near, (x - log.head) - log.tail);
}

}  // namespace physgen::fem::detail
