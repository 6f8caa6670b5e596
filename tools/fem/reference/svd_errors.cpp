// Errors of an SVD, in extended precision.
#include <fem/reference/svd_errors.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

namespace physgen::fem::reference {

namespace {

using Long = long double;
using Long3 = Eigen::Matrix<Long, 3, 3>;

template <class Real>
constexpr Long eps = std::numeric_limits<Real>::epsilon();

// The part of an error beyond the rounding to subnormal numbers.
template <class Real>
Long beyond_underflow(Long error) {
  return std::max(Long(0), error - Long(std::numeric_limits<Real>::denorm_min()));
}

}  // namespace

template <class Real>
SvdErrors svd_residuals(const Matrix3<Real>& matrix, const Svd<Real>& svd) {
  SvdErrors errors;
  errors.finite = svd.U.allFinite() && svd.s.allFinite() && svd.V.allFinite();
  if (!errors.finite) return errors;
  const Long3 A = matrix.template cast<Long>(), U = svd.U.template cast<Long>(), V = svd.V.template cast<Long>();
  const Eigen::Matrix<Long, 3, 1> s = svd.s.template cast<Long>();
  const Long norm = A.norm(), residual = beyond_underflow<Real>((U * s.asDiagonal() * V.transpose() - A).norm());
  errors.residual = static_cast<double>(residual / (norm > 0 ? norm : 1) / eps<Real>);
  errors.orthogonality = 0;
  for (const Long3& Q : {U, V}) {
    const Long product = (Q.transpose() * Q - Long3::Identity()).cwiseAbs().maxCoeff();
    const Long worst = std::max(product, std::abs(Q.determinant() - 1));
    errors.orthogonality = std::max(errors.orthogonality, static_cast<double>(worst / eps<Real>));
  }
  errors.ordered = s[0] >= s[1] && s[1] >= std::abs(s[2]);
  return errors;
}

template <class Real>
SvdErrors svd_errors(const Matrix3<Real>& matrix, const Svd<Real>& svd) {
  SvdErrors errors = svd_residuals(matrix, svd);
  if (!errors.finite) return errors;
  // The reference is computed at norm 1, where nothing under- or overflows.
  const Long3 A = matrix.template cast<Long>();
  const Long norm = A.norm() > 0 ? A.norm() : 1;
  const Eigen::JacobiSVD<Long3> exact(A / norm, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const auto& s = exact.singularValues();
  const Long largest = std::max(s[0], Long(1e-30));
  errors.values = 0;
  for (int k = 0; k < 3; ++k) {
    const Long error = beyond_underflow<Real>(std::abs(std::abs(Long(svd.s[k])) - s[k] * norm));
    errors.values = std::max(errors.values, static_cast<double>(error / norm / largest / eps<Real>));
  }
  const bool clear = s[2] > 16 * eps<Real> * largest && s[2] * norm > 2 * Long(std::numeric_limits<Real>::denorm_min());
  // Not from det A itself, which may be all rounding when two singular values are small.
  const bool negative = exact.matrixU().determinant() * exact.matrixV().determinant() < 0;
  errors.sign_of_det = !clear || negative == std::signbit(svd.s[2]);
  return errors;
}

template SvdErrors svd_residuals<float>(const Matrix3<float>&, const Svd<float>&);
template SvdErrors svd_residuals<double>(const Matrix3<double>&, const Svd<double>&);
template SvdErrors svd_errors<float>(const Matrix3<float>&, const Svd<float>&);
template SvdErrors svd_errors<double>(const Matrix3<double>&, const Svd<double>&);

}  // namespace physgen::fem::reference
