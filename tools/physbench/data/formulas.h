// Formulas in plain Eigen that several kernels' references share, in any precision; two of them, which take long to
// compile, are compiled in formulas.cpp once.
#pragma once

#include <elasticity.physgen.h>
#include <fem/materials/neo_hookean.h>

#include <cmath>
#include <type_traits>

namespace physgen::bench {

template <class T>
using Vector3 = Eigen::Matrix<T, 3, 1>;
template <class T>
using Matrix3 = Eigen::Matrix<T, 3, 3>;

/// The type that the reference of a result in Real is computed in.
template <class Real>
using Wider = std::conditional_t<std::is_same_v<Real, float>, double, long double>;

/// The material of all rows: silicone.
inline constexpr double youngs_modulus = 15e3;  ///< [Pa]
inline constexpr double poissons_ratio = 0.45;

template <class Real>
fem::NeoHookean<Real> material() {
  return fem::NeoHookean<Real>::from(youngs_modulus, poissons_ratio);
}

namespace formula {

/// Lame constants in T, rounded to Real first: a kernel in Real knows no better ones.
template <class T, class Real>
struct Lame {
  T mu = T(Real(youngs_modulus / (2 * (1 + poissons_ratio))));
  T lambda = T(Real(youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio))));
};

/// phi'(J) and phi''(J) [Pa] of the Neo-Hookean psi = mu/2 (I1 - 3) + phi(J), phi = -mu ln J + lambda/2 ln^2 J, with
/// phi' continued linearly below J0.
template <class T>
struct VolumeSlopes {
  T first, second;
};
template <class T, class Real>
VolumeSlopes<T> volume_slopes(const Lame<T, Real>& lame, T J) {
  const T J0 = T(fem::NeoHookean<Real>().smallest_volume_ratio), held = J < J0 ? J0 : J, log = std::log(held);
  const T second = (lame.mu + lame.lambda * (1 - log)) / (held * held);
  return {(lame.lambda * log - lame.mu) / held + second * (J - held), second};
}

/// Edge vectors of a tet from corner i, by columns. @param at at(node) is a vector
template <class T, class Nodes, class At>
Matrix3<T> edges(const Nodes& nodes, const At& at) {
  const Vector3<T> origin = at(nodes[0]).template cast<T>();
  Matrix3<T> d;
  for (int c = 0; c < 3; ++c) d.col(c) = at(nodes[c + 1]).template cast<T>() - origin;
  return d;
}

/// F = U diag(s) V^T with rotations U and V; all NaN where F is not finite. For float, double and long double.
template <class T>
elasticity::DeformationSvd<T> svd(const Matrix3<T>& F);

/// The symmetric matrix with the eigenvalues function(lambda). For double and long double.
template <class T>
Matrix3<T> map_eigenvalues(const Matrix3<T>& symmetric, T (*function)(T));

template <class T, class Real>
Matrix3<T> stress(const elasticity::DeformationSvd<T>& svd) {
  const Lame<T, Real> lame;
  const Vector3<T>& s = svd.s;
  const Vector3<T> c(s[1] * s[2], s[0] * s[2], s[0] * s[1]);  // dJ/ds
  const Vector3<T> g = lame.mu * s + volume_slopes(lame, s.prod()).first * c;
  return svd.U * g.asDiagonal() * svd.V.transpose();
}

template <class T, class Real>
elasticity::StressDerivative<T> stress_derivative(const Vector3<T>& s) {
  const Lame<T, Real> lame;
  const auto phi = volume_slopes(lame, s.prod());
  const Vector3<T> c(s[1] * s[2], s[0] * s[2], s[0] * s[1]);  // dJ/ds
  const T mu = lame.mu;
  const auto same = [&](int a) { return mu + phi.second * c[a] * c[a]; };
  const auto mixed = [&](int a, int b) { return phi.second * c[a] * c[b] + phi.first * s[3 - a - b]; };
  const auto swapped = [&](int a, int b) { return -phi.first * s[3 - a - b]; };  // (D - S) / 2; (D + S) / 2 is mu
  return {same(0), mixed(1, 0),   mixed(2, 0), same(1),       mixed(2, 1), same(2),
          mu,      swapped(1, 0), mu,          swapped(2, 0), mu,          swapped(2, 1)};
}

/// The 12 entries in the order of elasticity::StressDerivative.
template <class T>
Eigen::Matrix<T, 12, 1> entries(const auto& x) {
  Eigen::Matrix<T, 12, 1> all;
  all << T(x.x1111), T(x.x2211), T(x.x3311), T(x.x2222), T(x.x3322), T(x.x3333), T(x.x2121), T(x.x2112), T(x.x3131),
      T(x.x3113), T(x.x3232), T(x.x3223);
  return all;
}

template <class T, class Derivative>
Matrix3<T> dp_from_df(const Matrix3<T>& U, const Matrix3<T>& V, const Derivative& x, const Matrix3<T>& dF) {
  const Matrix3<T> f = U.transpose() * dF * V;
  Matrix3<T> p;
  p(0, 0) = T(x.x1111) * f(0, 0) + T(x.x2211) * f(1, 1) + T(x.x3311) * f(2, 2);
  p(1, 1) = T(x.x2211) * f(0, 0) + T(x.x2222) * f(1, 1) + T(x.x3322) * f(2, 2);
  p(2, 2) = T(x.x3311) * f(0, 0) + T(x.x3322) * f(1, 1) + T(x.x3333) * f(2, 2);
  p(1, 0) = T(x.x2121) * f(1, 0) + T(x.x2112) * f(0, 1);
  p(0, 1) = T(x.x2112) * f(1, 0) + T(x.x2121) * f(0, 1);
  p(2, 0) = T(x.x3131) * f(2, 0) + T(x.x3113) * f(0, 2);
  p(0, 2) = T(x.x3113) * f(2, 0) + T(x.x3131) * f(0, 2);
  p(2, 1) = T(x.x3232) * f(2, 1) + T(x.x3223) * f(1, 2);
  p(1, 2) = T(x.x3223) * f(2, 1) + T(x.x3232) * f(1, 2);
  return U * p * V.transpose();
}

template <class T, class Rest>
Matrix3<T> corner_forces(const Rest& rest, const Matrix3<T>& P) {
  return -T(rest.volume) * P * rest.dm_inverse.template cast<T>().transpose();
}

/// The force on corner c of a tet.
template <class T, class Forces>
Vector3<T> force_on(const Forces& forces, int corner) {
  const Matrix3<T> G = forces.G.template cast<T>();
  return corner == 0 ? Vector3<T>(-G.rowwise().sum()) : Vector3<T>(G.col(corner - 1));
}

}  // namespace formula

}  // namespace physgen::bench
