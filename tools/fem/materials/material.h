// The common part of the material models: Lame constants from E and nu, and the isotropic stress derivative in
// principal axes. A model is a small struct of constants with three functions of the principal stretches s: energy,
// stress, derivative.
#pragma once

#include <fem/numerics/log.h>

#include <limits>
#include <string>

namespace physgen::fem {

struct LameParameters {
  double mu, lambda;  ///< [Pa]
};

/// Lame constants of a linear-elastic solid.
/// @param youngs_modulus E > 0 [Pa]
/// @param poissons_ratio nu, -1 < nu < 0.5
/// @param model name for the message
/// @throws Error naming the model, the constant, its value and the range, when one is out of range or not finite
[[nodiscard]] LameParameters lame_parameters(double youngs_modulus, double poissons_ratio, const char* model);

/// @throws Error naming the model, the constant, its value and the allowed range
[[noreturn]] void refuse_constant(const char* model, const char* constant, double value, const std::string& range);

/// The sign that a constant may have.
enum class ConstantSign { Positive, PositiveOrZero, Any };

/// @param smallest of a positive constant, @param largest of any constant's magnitude [Pa]
/// @throws Error as refuse_constant() does, when the constant is not finite, out of these bounds or of the wrong sign
void require_constant(const char* model, const char* constant, double value, ConstantSign sign, double smallest,
                      double largest);

/// A constant [Pa] in a model's precision. It is a normal number, so that it keeps its digits, and at most 1/16 of the
/// largest, so that sums such as 3 mu + lambda are finite; one of either sign (lambda) may be as small as it likes.
/// @throws Error as require_constant() does
template <class Real>
[[nodiscard]] Real constant_of(double value, const char* model, const char* constant,
                               ConstantSign sign = ConstantSign::Positive) {
  using Limits = std::numeric_limits<Real>;
  require_constant(model, constant, value, sign, double(Limits::min()), double(Limits::max()) / 16);
  return static_cast<Real>(value);
}

/// U(J) of a model whose energy has such a part, of the volume alone: half its modulus times the square of ln J, or of
/// J - 1.
enum class VolumeLaw { logarithmic, quadratic };

/// The derivative of the principal stresses g by the principal stretches s, and of the axes of stress. Every model
/// gives these 12 numbers from closed forms, never as quotients of differences, so s_a = s_b is an ordinary input.
template <class S>
struct PrincipalDerivative {
  S h11, h21, h31, h22, h32, h33;  ///< H_ik = d2psi / (ds_i ds_k) [Pa]
  S d21, d31, d32;                 ///< D_ab = (g_a - g_b) / (s_a - s_b) [Pa]
  S s21, s31, s32;                 ///< S_ab = (g_a + g_b) / (s_a + s_b) [Pa]
};

// A model looks like this (Real: float or double; S: Real or a SIMD pack of it):
//
//   template <class Real> struct Model {
//     using Scalar = Real;
//     static constexpr const char* name;
//     static Model from(double youngs_modulus, double poissons_ratio);                 // throws Error
//     template <class S> S energy(const Vector3<S>& s) const;                          // psi(s) [J/m^3]
//     template <class S> Vector3<S> stress(const Vector3<S>& s) const;                 // g = dpsi/ds
//     template <class S> PrincipalDerivative<S> derivative(const Vector3<S>& s) const;
//     // Where the energy has a part U(J), which patches of tets or nodes may average:
//     static constexpr VolumeLaw volume_law;
//     Real& volume_modulus();                                                          // [Pa]; 0 leaves U(J) out
//   };
//
// s1 >= s2 >= |s3| as svd() gives them; s3 < 0 (an inverted element) is ordinary input. NaN and infinity in s come out
// as NaN or infinity. The energy is 0 at rest. A model has a header in materials/, a row in materials.h and its
// energy, written plainly, in reference/energy.h: with these, the tests of every material run over it.

namespace detail {

/// J = s1 s2 s3 in two parts: its error is of order eps^2. So J - 1 = (head - 1) + tail has no cancellation near rest,
/// where head - 1 is exact, and is better than sums of products of e = s - 1, which round every term.
template <class S>
PHYSGEN_FUNCTION inline TwoPart<S> volume_ratio(const Vector3<S>& s) {
  const TwoPart<S> area = two_product(s[0], s[1]);
  const TwoPart<S> J = two_product(area.head, s[2]);
  return {J.head, fma(area.tail, s[2], J.tail)};
}

/// J - 1
template <class S>
PHYSGEN_FUNCTION inline S volume_change(const TwoPart<S>& J) {
  return (J.head - S(RealOf<S>(1))) + J.tail;
}

/// J, held at J0 where it is below, and how far below it is: what models with a pole at J = 0 are continued with.
template <class S>
struct HeldVolumeRatio {
  TwoPart<S> held;  ///< max(J, J0)
  S beyond;         ///< J - J0 where that is negative, else 0
};
template <class S>
PHYSGEN_FUNCTION inline HeldVolumeRatio<S> hold(const TwoPart<S>& J, const S& J0) {
  const S zero(RealOf<S>(0));
  const auto below = J.head < J0;  // not of NaN, which stays
  return {{select(below, J0, J.head), select(below, zero, J.tail)}, select(below, (J.head - J0) + J.tail, zero)};
}

/// I1 - 3, without cancellation near rest.
template <class S>
PHYSGEN_FUNCTION inline S stretch_change(const Vector3<S>& s) {
  const S one(RealOf<S>(1)), two(RealOf<S>(2));
  const S e1 = s[0] - one, e2 = s[1] - one, e3 = s[2] - one;
  return fma(e1, two + e1, fma(e2, two + e2, e3 * (two + e3)));
}

/// s_a + s_b, held away from 0 by `smallest`, with its sign: the denominators of the corotated models.
template <class S>
PHYSGEN_FUNCTION inline S held_stretch_sum(const S& a, const S& b, const S& smallest) {
  const S sum = a + b;
  return select(abs(sum) < smallest, copysign(smallest, sum), sum);
}

}  // namespace detail
}  // namespace physgen::fem
