// What a problem is: the mathematical task that several kernels solve, with the reference and the measure of error.
//
//   template <class Real> struct SvdProblem {
//     using T = Wider<Real>;
//     struct Input;                                             in Real
//     using Reference;                                          in T
//     using Result;                                             in T, of any kernel that solves it
//     static constexpr std::size_t numbers; words;              how an input is written, for replay: how many, and what
//     static std::vector<Input> inputs(InputSet, index_t count);
//     static Input read(const Real* numbers);
//     static std::vector<Real> write(const Input&);
//     static Reference reference(const Input&);
//     static Result exact(const Reference&);                    the reference as a result, for printing
//     static InputErrors errors(const Input&, const Reference&, const Result&);
//     static std::vector<Named<T>> name_all(const Result&);     for printing
//   };
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "../naive.h"
#include "input_sets.h"

namespace physgen::bench {

template <class Problem>
Samples<Problem> InputSets::make(InputSet set) const {
  Samples<Problem> made;
  made.inputs = Problem::inputs(set, samples());
  made.references.resize(made.inputs.size());
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < made.inputs.size(); ++i) made.references[i] = Problem::reference(made.inputs[i]);
  return made;
}

/// Of one result, in eps of the storage. NaN where the result is not a number.
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

}  // namespace physgen::bench
