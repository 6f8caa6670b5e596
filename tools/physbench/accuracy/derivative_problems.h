// The stress derivative and dP from dF, and what their errors are.
#pragma once

#include <array>

#include "problem.h"

namespace physgen::bench {

/// F whose Neo-Hookean stress derivative is finite in float with room: of norms 1e-6 to 1e4. Inverted, flattened and
/// rank deficient elements are among them.
template <class Real>
std::vector<Matrix3<Real>> bounded_deformations(InputSet set, index_t count) {
  return deformations<Real>(set, count, 1e-6, 1e4);
}

/// An SVD as kernels get it.
template <class Real>
elasticity::DeformationSvd<Real> rounded_svd(const Matrix3<Real>& F) {
  const auto exact = detail::svd<Wider<Real>>(F.template cast<Wider<Real>>());
  elasticity::DeformationSvd<Real> svd;
  svd.U = exact.U.template cast<Real>();
  svd.V = exact.V.template cast<Real>();
  svd.s = exact.s.template cast<Real>();
  return svd;
}

/// What the filters of definiteness.h do, from Eigen's eigenvalues: function objects of one eigenvalue.
namespace filter {
struct None {
  static constexpr bool filters = false;
};
struct Clamp {
  static constexpr bool filters = true;
  template <class T>
  static T value(T eigenvalue) {
    return eigenvalue < 0 ? T(0) : eigenvalue;
  }
};
struct Absolute {
  static constexpr bool filters = true;
  template <class T>
  static T value(T eigenvalue) {
    return std::abs(eigenvalue);
  }
};
}  // namespace filter

/// The error of a stress derivative is the largest error of its 12 entries, over the largest entry.
template <class Real, class Filter>
struct StressDerivativeProblem {
  using T = Wider<Real>;
  struct Input {
    Vector3<Real> s;
  };
  using Result = Eigen::Matrix<T, 12, 1>;  ///< in the order of elasticity::StressDerivative
  using Reference = Result;

  static constexpr std::size_t numbers = 3;
  static constexpr const char* words = "3 numbers, the principal stretches s1 >= s2 >= |s3|";
  static std::vector<Input> inputs(InputSet set, index_t count) {
    const auto gradients = bounded_deformations<Real>(set, count);
    std::vector<Input> made(gradients.size());
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < made.size(); ++i) made[i] = {rounded_svd<Real>(gradients[i]).s};
    return made;
  }
  static Input read(const Real* numbers) { return {Vector3<Real>(numbers[0], numbers[1], numbers[2])}; }
  static std::vector<Real> write(const Input& input) { return named("s", input.s).numbers; }

  static Reference reference(const Input& input) {
    const std::array<Input, 1> inputs{input};
    const auto exact = Naive<StressDerivative>::template value<T, Real>(0, inputs);
    Result x = Naive<StressDerivative>::template observe<T>(exact);
    if constexpr (Filter::filters) {
      if (!x.allFinite()) return Result::Constant(std::numeric_limits<T>::quiet_NaN());
      Matrix3<T> block;
      block << x[0], x[1], x[2], x[1], x[3], x[4], x[2], x[4], x[5];
      const Eigen::SelfAdjointEigenSolver<Matrix3<T>> eigen(block);
      const Vector3<T> values = eigen.eigenvalues().unaryExpr([](T value) { return Filter::value(value); });
      block = eigen.eigenvectors() * values.asDiagonal() * eigen.eigenvectors().transpose();
      x.template head<6>() << block(0, 0), block(1, 0), block(2, 0), block(1, 1), block(2, 1), block(2, 2);
      for (int pair = 6; pair < 12; pair += 2) {
        const T d = Filter::value(x[pair] + x[pair + 1]), s = Filter::value(x[pair] - x[pair + 1]);
        x[pair] = (d + s) / 2, x[pair + 1] = (d - s) / 2;
      }
    }
    return x;
  }
  static Result exact(const Reference& reference) { return reference; }

  static InputErrors errors(const Input& /*input*/, const Reference& reference, const Result& result) {
    const T error = (result - reference).cwiseAbs().template maxCoeff<Eigen::PropagateNaN>();
    const T largest = reference.cwiseAbs().maxCoeff();
    return {static_cast<double>(error / (largest > 0 ? largest : T(1)) / std::numeric_limits<Real>::epsilon()), {}};
  }
  static std::vector<Named<T>> name_all(const Result& result) { return {named("x", result)}; }
};

/// The error of dP is |dP - ref| / (|x|max |dF|), norms Frobenius: entries of dP may cancel.
template <class Real>
struct DpFromDfProblem {
  using T = Wider<Real>;
  struct Input {
    Matrix3<Real> F, dF;
    elasticity::DeformationSvd<Real> svd;  ///< of F, rounded
    elasticity::StressDerivative<Real> x;  ///< at s, rounded
  };
  struct Reference {
    Matrix3<T> dP;
    T scale;  ///< |x|max |dF|
  };
  using Result = Matrix3<T>;

  static constexpr std::size_t numbers = 18;
  static constexpr const char* words = "18 numbers, F by columns and dF by columns";
  static Input make(const Matrix3<Real>& F, const Matrix3<Real>& dF) {
    Input input{F, dF, rounded_svd<Real>(F), {}};
    const std::array<elasticity::DeformationSvd<Real>, 1> svds{input.svd};
    const auto x = Naive<StressDerivative>::template value<T, Real>(0, svds);
    input.x = {Real(x.x1111), Real(x.x2211), Real(x.x3311), Real(x.x2222), Real(x.x3322), Real(x.x3333),
               Real(x.x2121), Real(x.x2112), Real(x.x3131), Real(x.x3113), Real(x.x3232), Real(x.x3223)};
    return input;
  }
  static std::vector<Input> inputs(InputSet set, index_t count) {
    const auto gradients = bounded_deformations<Real>(set, count);
    const auto changes = differentials<Real>(gradients);
    std::vector<Input> made(gradients.size());
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < made.size(); ++i) made[i] = make(gradients[i], changes[i]);
    return made;
  }
  static Input read(const Real* numbers) { return make(matrix_of(numbers), matrix_of(numbers + 9)); }
  static std::vector<Real> write(const Input& input) {
    std::vector<Real> all = named("F", input.F).numbers, more = named("dF", input.dF).numbers;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  static Reference reference(const Input& input) {
    const Matrix3<T> dF = input.dF.template cast<T>();
    const T largest = Naive<StressDerivative>::template observe<T>(input.x).cwiseAbs().maxCoeff();
    return {detail::dp_from_df<T>(input.svd.U.template cast<T>(), input.svd.V.template cast<T>(), input.x, dF),
            largest * dF.norm()};
  }
  static Result exact(const Reference& reference) { return reference.dP; }

  static InputErrors errors(const Input& /*input*/, const Reference& reference, const Result& result) {
    const T scale = reference.scale == 0 ? T(1) : reference.scale;
    return {static_cast<double>((result - reference.dP).norm() / scale / std::numeric_limits<Real>::epsilon()), {}};
  }
  static std::vector<Named<T>> name_all(const Result& result) { return {named("dP", result)}; }
};

}  // namespace physgen::bench
