// The common part of the tests of the eigenvalue filters: the 3x3 block as a matrix, its exact filters, and a filter's
// errors.
#pragma once

#include <fem/materials/definiteness.h>

#include <Eigen/Eigenvalues>

#include "material_checks.h"

namespace physgen::fem {

using Long3 = Eigen::Matrix<long double, 3, 3>;
/// A derivative with H in its 3x3 block; its pairs are D 1 -2 0, S -0.5 3 -1.
template <class Real>
PrincipalDerivative<Real> derivative_of(const Eigen::Matrix3d& H) {
  const auto h = [&H](int r, int c) { return static_cast<Real>(H(r, c)); };
  return {h(0, 0), h(1, 0),  h(2, 0), h(1, 1),    h(2, 1), h(2, 2),
          Real(1), Real(-2), Real(0), Real(-0.5), Real(3), Real(-1)};
}

/// With h11 h21 h31 h22 h32 h33.
template <class Real>
PrincipalDerivative<Real> derivative_of(const std::array<double, 6>& h) {
  Eigen::Matrix3d H;
  H << h[0], h[1], h[2], h[1], h[3], h[4], h[2], h[4], h[5];
  return derivative_of<Real>(H);
}

template <class Real>
std::array<double, 6> block_entries(const PrincipalDerivative<Real>& d) {
  return {double(d.h11), double(d.h21), double(d.h31), double(d.h22), double(d.h32), double(d.h33)};
}

template <class Real>
Long3 block(const PrincipalDerivative<Real>& d) {
  Long3 H;
  H << d.h11, d.h21, d.h31, d.h21, d.h22, d.h32, d.h31, d.h32, d.h33;
  return H;
}

/// H with its eigenvalues clamped or made absolute.
inline Long3 exactly(const Long3& H, bool clamp) {
  const Eigen::SelfAdjointEigenSolver<Long3> e(H);
  const Eigen::Matrix<long double, 3, 1> values =
      clamp ? e.eigenvalues().cwiseMax(0).eval() : e.eigenvalues().cwiseAbs().eval();
  return e.eigenvectors() * values.asDiagonal() * e.eigenvectors().transpose();
}

/// Errors of both filters in eps |H|: of the clamped and the absolute block, and how far below zero the least
/// eigenvalue of either is.
struct FilterErrors {
  double clamped, absolute, negative;
  [[nodiscard]] double largest() const {
    const double sum = clamped + absolute + negative;
    return std::isnan(sum) ? sum : std::max({clamped, absolute, negative});
  }
};
template <class Real>
FilterErrors filter_errors(const PrincipalDerivative<Real>& d) {
  const Long3 H = block(d), C = block(ClampEigenvalues{}(d)), A = block(AbsoluteEigenvalues{}(d));
  const long double unit = H.norm() * static_cast<long double>(std::numeric_limits<Real>::epsilon());
  const Eigen::SelfAdjointEigenSolver<Long3> c(C), a(A);
  return {static_cast<double>((C - exactly(H, true)).norm() / unit),
          static_cast<double>((A - exactly(H, false)).norm() / unit),
          static_cast<double>(-std::min(c.eigenvalues()[0], a.eigenvalues()[0]) / unit)};
}

}  // namespace physgen::fem
