// Corotated linear solid, psi = mu sum (s - 1)^2 + lambda/2 (sum (s - 1))^2: linear elasticity after the rotation of F
// is taken out, with one pole in the derivative, where s_a + s_b = 0 and that rotation is not unique.
#pragma once

#include <fem/materials/material.h>

namespace physgen::fem {

/// S_ab = (g_a + g_b) / (s_a + s_b) contains -2 (2 mu - lambda T) / (s_a + s_b), T = sum (s - 1). There |s_a + s_b| is
/// held at or above smallest_stretch_sum, so that |S_ab| <= 2 mu + 2 |2 mu - lambda T| / smallest_stretch_sum;
/// elsewhere the value is not changed.
template <class Real>
struct Corotated {
  using Scalar = Real;
  static constexpr const char* name = "corotated";

  Real mu, lambda;                         ///< Lame constants [Pa]
  Real smallest_stretch_sum = Real(1e-3);  ///< cap at the pole; any 1e-6 <= cap <= 1 [1]

  /// @throws Error as lame_parameters() and constant_of() do
  static Corotated from(double youngs_modulus, double poissons_ratio) {
    const LameParameters lame = lame_parameters(youngs_modulus, poissons_ratio, name);
    return {constant_of<Real>(lame.mu, name, "mu"), constant_of<Real>(lame.lambda, name, "lambda", ConstantSign::Any)};
  }

  /// @return psi [J/m^3]
  /// Error <= 8 eps of |psi| + mu |s - 1|^2.
  template <class S>
  PHYSGEN_FUNCTION S energy(const Vector3<S>& s) const {
    const S one(Real(1)), T = trace(s).head;
    const S e1 = s[0] - one, e2 = s[1] - one, e3 = s[2] - one;
    return fma(S(mu), fma(e1, e1, fma(e2, e2, e3 * e3)), S(lambda / 2) * (T * T));
  }

  /// @return g = dpsi/ds [Pa]
  /// Error <= 8 eps |H| |s|.
  template <class S>
  PHYSGEN_FUNCTION Vector3<S> stress(const Vector3<S>& s) const {
    const S one(Real(1)), m2(2 * mu), pressure = S(lambda) * trace(s).head;
    return {fma(m2, s[0] - one, pressure), fma(m2, s[1] - one, pressure), fma(m2, s[2] - one, pressure)};
  }

  /// @return the 12 entries [Pa]. Error <= 8 eps of the largest.
  /// 2 mu - lambda T comes from T in two parts, which keeps its digits where it vanishes beside the pole.
  template <class S>
  PHYSGEN_FUNCTION PrincipalDerivative<S> derivative(const Vector3<S>& s) const {
    const S two(Real(2)), smallest(smallest_stretch_sum);
    const TwoPart<S> T = trace(s);
    const TwoPart<S> pressure = two_product(S(lambda), T.head);
    const S nothing = S(Real(0)) * pressure.head;  // NaN of NaN: it reaches the entries that do not depend on s as well
    const S l = S(lambda) + nothing, m2 = S(2 * mu) + nothing, h = m2 + l;
    const S rest = two * ((m2 - pressure.head) - fma(l, T.tail, pressure.tail));
    const auto turning = [&](const S& a, const S& b) { return m2 - rest / detail::held_stretch_sum(a, b, smallest); };
    return {h, l, l, h, l, h, m2, m2, m2, turning(s[0], s[1]), turning(s[0], s[2]), turning(s[1], s[2])};
  }

 private:
  // T = s1 + s2 + s3 - 3.
  template <class S>
  PHYSGEN_FUNCTION static TwoPart<S> trace(const Vector3<S>& s) {
    const TwoPart<S> two = two_sum(s[0], s[1]), three = two_sum(two.head, s[2]);
    const TwoPart<S> less = two_sum(three.head, S(Real(-3)));
    return fast_two_sum<S>(less.head, less.tail + (three.tail + two.tail));
  }
};

}  // namespace physgen::fem
