// Measures how far a 3x3 SVD is from a correct one, in eps of its precision, against extended precision. These are the
// quantities that svd() promises to bound.
#pragma once

#include <fem/numerics/svd.h>

#include <limits>

namespace physgen::fem::reference {

/// Errors of one SVD; infinite where its numbers are not finite.
struct SvdErrors {
  bool finite = false;  ///< all numbers are
  /// |U diag(s) V^T - A| / |A|, Frobenius, less one smallest subnormal [eps]
  double residual = std::numeric_limits<double>::infinity();
  /// Largest entry of |Q^T Q - I|, and |det Q - 1|, over Q = U, V [eps]
  double orthogonality = std::numeric_limits<double>::infinity();
  /// Largest |s - s_ref| / s1, less one smallest subnormal [eps]
  double values = std::numeric_limits<double>::infinity();
  bool ordered = false;      ///< s1 >= s2 >= |s3|
  bool sign_of_det = false;  ///< sign(s3) = sign(det A), or s3 is below 16 eps s1
};

/// The errors that need no reference decomposition, and so are fast: finite, residual, orthogonality, ordered.
template <class Real>
[[nodiscard]] SvdErrors svd_residuals(const Matrix3<Real>& A, const Svd<Real>& svd);
/// All of them.
template <class Real>
[[nodiscard]] SvdErrors svd_errors(const Matrix3<Real>& A, const Svd<Real>& svd);

}  // namespace physgen::fem::reference
