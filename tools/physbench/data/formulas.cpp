// Decompositions of Eigen, compiled once.
#include "data/formulas.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <limits>

namespace physgen::bench::formula {

template <class T>
elasticity::DeformationSvd<T> svd(const Matrix3<T>& F) {
  elasticity::DeformationSvd<T> result;
  if (!F.allFinite()) {  // Eigen gives nothing then, not even NaN
    result.U = result.V = Matrix3<T>::Constant(std::numeric_limits<T>::quiet_NaN());
    result.s = result.U.col(0);
    return result;
  }
  const Eigen::JacobiSVD<Matrix3<T>> found(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
  result.U = found.matrixU();
  result.V = found.matrixV();
  result.s = found.singularValues();
  for (auto* rotation : {&result.U, &result.V}) {
    if (rotation->determinant() > 0) continue;
    rotation->col(2) = -rotation->col(2);
    result.s[2] = -result.s[2];
  }
  return result;
}

template <class T>
Matrix3<T> map_eigenvalues(const Matrix3<T>& symmetric, T (*function)(T)) {
  const Eigen::SelfAdjointEigenSolver<Matrix3<T>> eigen(symmetric);
  const Vector3<T> values = eigen.eigenvalues().unaryExpr([function](T value) { return function(value); });
  return eigen.eigenvectors() * values.asDiagonal() * eigen.eigenvectors().transpose();
}

template elasticity::DeformationSvd<float> svd(const Matrix3<float>&);
template elasticity::DeformationSvd<double> svd(const Matrix3<double>&);
template elasticity::DeformationSvd<long double> svd(const Matrix3<long double>&);
template Matrix3<double> map_eigenvalues(const Matrix3<double>&, double (*)(double));
template Matrix3<long double> map_eigenvalues(const Matrix3<long double>&, long double (*)(long double));

}  // namespace physgen::bench::formula
