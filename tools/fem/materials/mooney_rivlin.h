// Compressible Mooney-Rivlin solid, psi = m10 (J^(-2/3) I1 - 3) + m01 (J^(-4/3) I2 - 3) + kappa/2 ln^2 J, the common
// model of muscle and fat; continued below a small J so that flattened and inverted elements have finite forces.
#pragma once

#include <fem/materials/material.h>
#include <fem/numerics/inverse_cube_root.h>

namespace physgen::fem {

/// The constants of MooneyRivlin: m10 and m01 >= 0 and not both 0, kappa > 0.
struct MooneyRivlinConstants {
  double m10, m01, kappa;  ///< [Pa]
};

/// I1 = sum s^2 and I2 = (I1^2 - sum s^4) / 2. The functions of J, a = m10 J^(-2/3), b = m01 J^(-4/3) and
/// c = kappa/2 ln^2 J, each go on below J0 = smallest_volume_ratio as their quadratic Taylor polynomials at J0. So
/// there is an energy everywhere, the stress is continuously differentiable in s across J0 and across inversion, and
/// the pole at s -> 0 is gone.
///
/// Everything follows from three numbers at max(J, J0) and x = (J - J0) / J0 below J0, else 0:
/// a = a0 (1 - 2/3 x + 5/9 x^2), b = b0 (1 - 4/3 x + 14/9 x^2), c' J0 = kappa (L + (1 - L) x), L = ln max(J, J0).
template <class Real>
struct MooneyRivlin {
  using Scalar = Real;
  static constexpr const char* name = "Mooney-Rivlin";
  static constexpr VolumeLaw volume_law = VolumeLaw::logarithmic;

  Real m10, m01;                            ///< [Pa]; 2 (m10 + m01) is Lame's mu
  Real kappa;                               ///< bulk modulus [Pa], lambda + 2/3 mu
  Real smallest_volume_ratio = Real(0.25);  ///< J0; any 0.01 <= J0 <= 0.5 [1]

  /// With m10 : m01 = 3 : 1, the ratio of the muscle in Teran et al. 2005.
  /// @throws Error as lame_parameters() and constant_of() do
  static MooneyRivlin from(double youngs_modulus, double poissons_ratio) {
    const LameParameters lame = lame_parameters(youngs_modulus, poissons_ratio, name);
    return from(MooneyRivlinConstants{3 * lame.mu / 8, lame.mu / 8, lame.lambda + 2 * lame.mu / 3});
  }
  /// @throws Error as constant_of() does
  static MooneyRivlin from(const MooneyRivlinConstants& constants) {
    const Real m10 = constant_of<Real>(constants.m10, name, "m10", ConstantSign::PositiveOrZero);
    const Real m01 = constant_of<Real>(constants.m01, name, "m01", ConstantSign::PositiveOrZero);
    if (m10 == 0 && m01 == 0) refuse_constant(name, "m10 + m01", 0, "m10 > 0 or m01 > 0");
    return {m10, m01, constant_of<Real>(constants.kappa, name, "bulk modulus kappa")};
  }

  [[nodiscard]] Real& volume_modulus() { return kappa; }

  /// @return psi [J/m^3], without cancellation near rest: above J0, I1 - 3 J^(2/3) and I2 - 3 J^(4/3) are each the
  /// difference of an arithmetic and a geometric mean, p^3 + q^3 + r^3 - 3 p q r = (p + q + r) sum (p - q)^2 / 2.
  /// Error <= 8 eps of |psi| + mu |s - 1|^2.
  template <class S>
  PHYSGEN_FUNCTION S energy(const Vector3<S>& s) const {
    const S half(Real(0.5)), three(Real(3)), one(Real(1));
    const State<S> v = state(s);
    const S p = cube_root_squared(abs(s[0])), q = cube_root_squared(abs(s[1])), r = cube_root_squared(abs(s[2]));
    const auto difference = [](const S& root, const S& x, const S& other_root, const S& y) {
      return (x - y) * (x + y) / fma(root, root + other_root, other_root * other_root);
    };
    const S pq = difference(p, s[0], q, s[1]), pr = difference(p, s[0], r, s[2]), qr = difference(q, s[1], r, s[2]);
    const S stretch = half * (p + q + r) * fma(pq, pq, fma(pr, pr, qr * qr));
    const S a = r * pq, b = q * pr, c = p * qr;
    const S area = half * fma(p, q + r, q * r) * fma(a, a, fma(b, b, c * c));
    const S near = fma(v.a, stretch, v.b * area);
    const S x = v.x;
    const S far = fma(v.a, v.I1 * fma(x, fma(x, S(Real(5) / 9), S(-Real(2) / 3)), one), -three * S(m10)) +
                  fma(v.b, v.I2 * fma(x, fma(x, S(Real(14) / 9), S(-Real(4) / 3)), one), -three * S(m01));
    const S L = v.log.head;
    const S volume = S(kappa) * fma(half * L, L, x * fma(half * one_less_log(v.log), x, L));
    return select(x < S(Real(0)), far, near) + volume;
  }

  /// @return g = dpsi/ds [Pa]. With A = s_a^2 and so on, c_a = s_b s_c, and J0 for max(J, J0),
  /// g_a = s_a x^2 (40/9 a0 + 70/9 b0 (B + C)) +
  /// c_a / J0 (2/3 a0 (1 - 5/3 x) (2A - B - C) + 2/3 b0 (1 - 7/3 x) (B (A - C) + C (A - B)) + c' J0):
  /// every term vanishes at rest, and nothing is divided by s.
  /// Error <= 8 eps |H| |s|.
  template <class S>
  PHYSGEN_FUNCTION Vector3<S> stress(const Vector3<S>& s) const {
    const S one(Real(1));
    const State<S> v = state(s);
    const S x = v.x, square = x * x;
    const S a_rest = S(Real(40) / 9) * (v.a * square), b_rest = S(Real(70) / 9) * (v.b * square);
    const S two_thirds(Real(2) / 3);
    const S a = two_thirds * v.a * fma(S(-Real(5) / 3), x, one), b = two_thirds * v.b * fma(S(-Real(7) / 3), x, one);
    const S c = S(kappa) * fma(one_less_log(v.log), x, v.log.head);
    const S A = s[0] * s[0], B = s[1] * s[1], C = s[2] * s[2];
    const S AB = (s[0] - s[1]) * (s[0] + s[1]), AC = (s[0] - s[2]) * (s[0] + s[2]), BC = (s[1] - s[2]) * (s[1] + s[2]);
    // of axis 1: A, B, C and the differences A - B, A - C
    const auto axis = [&](const S& s1, const S& cofactor, const S& Y, const S& Z, const S& XY, const S& XZ) {
      const S isochoric = fma(a, XY + XZ, fma(b, fma(Y, XZ, Z * XY), c));
      return fma(cofactor * v.inverse, isochoric, s1 * fma(b_rest, Y + Z, a_rest));
    };
    return {axis(s[0], s[1] * s[2], B, C, AB, AC), axis(s[1], s[0] * s[2], A, C, -AB, BC),
            axis(s[2], s[0] * s[1], A, B, -AC, -BC)};
  }

  /// @return the 12 entries [Pa]. Error <= 8 eps of the largest or of what a relative eps of s changes, if that is more
  /// (measured, of the largest alone: 7.2). kappa (1 - ln J) may cancel against the rest of H_aa where J is large.
  /// With Phi(J) = I1 a + I2 b + c, of which I1 and I2 are held:
  /// H_aa = (2a + 4 J a') + (2b + 4 J b') (B + C) + Phi'' c_a^2,
  /// H_ab = 4 b s_a s_b + s_c (2 (A + B) a' + 2 (I2 + A B) b' + Phi'' J + Phi'),
  /// D = 2a + 2b (C - s_a s_b) - Phi' s_c, S = 2a + 2b (C + s_a s_b) + Phi' s_c.
  ///
  /// Parts of H_aa that would cancel are taken together: (c_a / J0)^2 A = (1 + x)^2, so that, of Phi'' J0^2, the terms
  /// 10/9 a0 A and 28/9 b0 A (B + C) join those of a and b.
  template <class S>
  PHYSGEN_FUNCTION PrincipalDerivative<S> derivative(const Vector3<S>& s) const {
    const S two(Real(2)), l(kappa);
    const State<S> v = state(s);
    const S x = v.x, inverse = v.inverse;
    const S a0I1 = v.a * v.I1, b0I2 = v.b * v.I2;
    // Phi'' J0^2; Phi' J0; and (Phi'' J + Phi') J0, in which the logarithm cancels
    const S volume = l * one_less_log(v.log);
    const S curvature = fma(S(Real(10) / 9), a0I1, fma(S(Real(28) / 9), b0I2, volume));
    const S slope = fma(curvature, x, fma(S(-Real(2) / 3), a0I1, fma(S(-Real(4) / 3), b0I2, l * v.log.head))) * inverse;
    const S mixed = fma(two * curvature, x, fma(S(Real(4) / 9), a0I1, fma(S(Real(16) / 9), b0I2, l)));
    // 2a, 2b; 2 a' J0, 2 b' J0; 2a + 4 J a' and 2b + 4 J b' with what comes from Phi''
    const S a2 = v.a * fma(x, fma(x, S(Real(10) / 9), S(-Real(4) / 3)), two);
    const S b2 = v.b * fma(x, fma(x, S(Real(28) / 9), S(-Real(8) / 3)), two);
    const S a_slope = v.a * fma(x, S(Real(20) / 9), S(-Real(4) / 3));
    const S b_slope = v.b * fma(x, S(Real(56) / 9), S(-Real(8) / 3));
    const S a_axis = v.a * fma(x, fma(x, S(Real(20) / 3), S(Real(8) / 3)), S(Real(4) / 9));
    const S b_axis = v.b * fma(x, fma(x, S(Real(56) / 3), S(Real(32) / 3)), S(-Real(2) / 9));
    const S a_curvature = S(Real(10) / 9) * v.a, b_curvature = S(Real(28) / 9) * v.b;
    const S A = s[0] * s[0], B = s[1] * s[1], C = s[2] * s[2];
    const S p1 = s[1] * s[2], p2 = s[0] * s[2], p3 = s[0] * s[1];
    const auto diagonal = [&](const S& sb, const S& sc, const S& cofactor, const S& others) {
      const S tail = fma(sb, sc, -cofactor);
      const S ratio = fma(cofactor, inverse, fma(cofactor, v.inverse_tail, tail * inverse));
      const S square = fma(cofactor, cofactor, (cofactor + cofactor) * tail);
      const S rest = fma(a_curvature, others, fma(b_curvature, square, volume));
      return fma(rest * ratio, ratio, fma(b_axis, others, a_axis));
    };
    const auto off_diagonal = [&](const S& product, const S& sum, const S& third_stretch) {
      const S bracket = fma(a_slope, sum, fma(b_slope, fma(product, product, v.I2), mixed));
      return fma(two * b2, product, third_stretch * inverse * bracket);
    };
    const auto pair = [&](const S& product, const S& third_square, const S& signed_third) {
      return fma(b2, third_square + product, fma(slope, signed_third, a2));
    };
    return {diagonal(s[1], s[2], p1, B + C),
            off_diagonal(p3, A + B, s[2]),
            off_diagonal(p2, A + C, s[1]),
            diagonal(s[0], s[2], p2, A + C),
            off_diagonal(p1, B + C, s[0]),
            diagonal(s[0], s[1], p3, A + B),
            pair(-p3, C, -s[2]),
            pair(-p2, B, -s[1]),
            pair(-p1, A, -s[0]),
            pair(p3, C, s[2]),
            pair(p2, B, s[1]),
            pair(p1, A, s[0])};
  }

 private:
  template <class S>
  struct State {
    S I1, I2;
    S a, b;                   // m10 J^(-2/3) and m01 J^(-4/3) at max(J, J0) [Pa]
    S inverse, inverse_tail;  // 1 / max(J, J0)
    S x;                      // (J - J0) / J0 below J0, else 0
    TwoPart<S> log;           // ln max(J, J0)
  };

  template <class S>
  PHYSGEN_FUNCTION State<S> state(const Vector3<S>& s) const {
    const auto J = detail::hold(detail::volume_ratio(s), S(smallest_volume_ratio));
    const S A = s[0] * s[0], B = s[1] * s[1], C = s[2] * s[2];
    const TwoPart<S> power = inverse_cube_root_squared(J.held);
    const S rough = S(Real(1)) / J.held.head;
    const S inverse_tail = rough * fma(-rough, J.held.tail, fma(-rough, J.held.head, S(Real(1))));
    return {fma(s[0], s[0], fma(s[1], s[1], s[2] * s[2])),
            fma(A, B + C, B * C),
            fma(S(m10), power.head, S(m10) * power.tail),
            S(m01) * fma(power.head, power.head, (power.head + power.head) * power.tail),
            rough,
            inverse_tail,
            J.beyond * rough,
            log_two_part(J.held.head, J.held.tail)};
  }

  template <class S>
  PHYSGEN_FUNCTION static S one_less_log(const TwoPart<S>& log) {
    return (S(Real(1)) - log.head) - log.tail;
  }
};

}  // namespace physgen::fem
