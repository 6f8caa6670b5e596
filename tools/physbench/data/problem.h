// A problem is the mathematical task that several kernels solve over the sets of inputs, with its reference and
// its measure of error. A kernel names its problem; that of the SVD stands in kernels/svd.h, and so on.
//
//   template <class Real> struct SvdProblem {
//     using T = Wider<Real>;
//     struct Input;                                             in Real
//     using Reference;                                          in T
//     using Result;                                             in T, of any kernel that solves it
//     static constexpr const char* name;
//     static constexpr std::size_t numbers; words;              how an input is written, for replay: how many, and what
//     static std::vector<Input> inputs(InputSet, index_t count);
//     static Input read(const Real* numbers);
//     static std::vector<Real> write(const Input&);
//     static auto values(const Input&);                         of the kernels' inputs, as a tuple
//     static Reference reference(const Input&);
//     static Result exact(const Reference&);                    the reference as a result, for printing
//     static InputErrors errors(const Input&, const Reference&, const Result&);
//     static std::vector<Named<T>> name_all(const Result&);     for printing
//   };
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "data/formulas.h"
#include "data/sets.h"

namespace physgen::bench {

/// The error of one result, in eps of the storage. NaN where the result is not a number.
struct InputErrors {
  double error = 0;
  std::optional<double> orthogonality;  ///< largest entry of |Q^T Q - I|, and |det Q - 1|, over the rotations Q
};

/// Numbers with their name, matrices by columns.
template <class T>
struct Named {
  std::string name;
  std::vector<T> numbers;
};

template <class Matrix>
auto named(const char* name, const Matrix& matrix) {
  using T = typename Matrix::Scalar;
  return Named<T>{name, std::vector<T>(matrix.data(), matrix.data() + matrix.size())};
}

/// The larger of both; NaN once there was one.
template <class T>
void raise(T& worst, T value) {
  if (!(value <= worst) && !std::isnan(worst)) worst = value;
}

/// The matrix of numbers by columns.
template <class Real>
Matrix3<Real> matrix_of(const Real* numbers) {
  return Eigen::Map<const Matrix3<Real>>(numbers);
}

/// F whose Neo-Hookean stress derivative is finite in float with room: of norms 1e-6 to 1e4. Inverted, flattened and
/// rank deficient elements are among them.
template <class Real>
std::vector<Matrix3<Real>> bounded_deformations(InputSet set, index_t count) {
  return deformations<Real>(set, count, 1e-6, 1e4);
}

/// An SVD as kernels get it.
template <class Real>
elasticity::DeformationSvd<Real> rounded_svd(const Matrix3<Real>& F) {
  const auto exact = formula::svd<Wider<Real>>(F.template cast<Wider<Real>>());
  elasticity::DeformationSvd<Real> svd;
  svd.U = exact.U.template cast<Real>();
  svd.V = exact.V.template cast<Real>();
  svd.s = exact.s.template cast<Real>();
  return svd;
}

}  // namespace physgen::bench
