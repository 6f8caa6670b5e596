// What the material models share: Lame constants from E and nu, and the isotropic stress derivative in principal axes.
// A model is a small struct of constants with three functions of the principal stretches s: energy, stress, derivative.
#pragma once

#include <fem/scalar.h>

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

/// How the principal stresses g follow the principal stretches s, and how stress turns with the axes. Every model gives
/// these 12 numbers from closed forms, never as quotients of differences, so s_a = s_b is an ordinary input.
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
//   };
//
// s1 >= s2 >= |s3| as svd() gives them; s3 < 0 (an inverted element) is ordinary input.

namespace detail {

/// J - 1 from e = s - 1 without forming J: exact to a few eps of the e near rest, where J - 1 would be all rounding.
template <class S>
PHYSGEN_FUNCTION inline S volume_change(const Vector3<S>& s) {
  const S one(RealOf<S>(1));
  const S e1 = s[0] - one, e2 = s[1] - one, e3 = s[2] - one;
  return fma(fma(e1, s[1], e2), s[2], e3);
}

/// s_a - s_b s_c from e = s - 1; zero at rest without cancellation.
template <class S>
PHYSGEN_FUNCTION inline S stretch_minus_cofactor(const S& a, const S& b, const S& c) {
  const S one(RealOf<S>(1));
  return (a - one) - fma(b - one, c, c - one);
}

}  // namespace detail
}  // namespace physgen::fem
