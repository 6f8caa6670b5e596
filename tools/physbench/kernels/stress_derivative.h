// The stress derivative in principal axes, and what its errors are; also where it is made positive semidefinite.
#pragma once

#include <fem/kernels/stress_derivative.h>
#include <fem/materials/definiteness.h>
#include <physgen/detail/host_loop.h>

#include <array>

#include "kernels/svd.h"

namespace physgen::bench {

/// The error of a stress derivative is the largest error of its 12 entries, over the largest entry.
/// @tparam Filter of an eigenvalue: filter(lambda), or nothing
template <class Real, class Filter>
struct StressDerivativeProblem {
  using T = Wider<Real>;
  struct Input {
    Vector3<Real> s;
  };
  using Result = Eigen::Matrix<T, 12, 1>;  ///< in the order of elasticity::StressDerivative
  using Reference = Result;

  static constexpr const char* name = Filter::name;
  static constexpr std::size_t numbers = 3;
  static constexpr const char* words = "3 numbers, the principal stretches s1 >= s2 >= |s3|";
  static std::vector<Input> inputs(InputSet set, index_t count) {
    const auto gradients = bounded_deformations<Real>(set, count);
    std::vector<Input> made(gradients.size());
    physgen::detail::host_loop(static_cast<index_t>(made.size()), [&](index_t k) {
      const auto i = static_cast<std::size_t>(k);
      made[i] = {rounded_svd<Real>(gradients[i]).s};
    });
    return made;
  }
  static Input read(const Real* numbers) { return {Vector3<Real>(numbers[0], numbers[1], numbers[2])}; }
  static std::vector<Real> write(const Input& input) { return named("s", input.s).numbers; }
  static auto values(const Input& input) {
    elasticity::DeformationSvd<Real> svd;
    svd.U.setIdentity(), svd.V.setIdentity();
    svd.s = input.s;
    return std::make_tuple(svd);
  }

  static Reference reference(const Input& input) {
    return filtered(formula::entries<T>(formula::stress_derivative<T, Real>(input.s.template cast<T>())));
  }
  /// The entries after the filter.
  static Result filtered(Result x) {
    if constexpr (requires { Filter::value(T()); }) {
      if (!x.allFinite()) return Result::Constant(std::numeric_limits<T>::quiet_NaN());
      Matrix3<T> block;
      block << x[0], x[1], x[2], x[1], x[3], x[4], x[2], x[4], x[5];
      block = formula::map_eigenvalues<T>(block, Filter::template value<T>);
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

/// @tparam Filter of the problem @tparam KernelFilter the same of fem/materials/definiteness.h
template <class Filter, class KernelFilter>
struct FilteredStressDerivative {
  static constexpr Domain domain = Domain::tets;
  using Output = elasticity::StressDerivativeObject;
  using Reads = Operands<Streamed<OutputOf<Svd>>>;
  using Writes = Operands<Streamed<source::Of<Output, Domain::tets>>>;
  template <class Real, class... View>
  static auto run(const View&... view) {
    return fem::ComputeStressDerivative{material<Real>(), view..., KernelFilter{}};
  }
  template <class Real>
  using Problem = StressDerivativeProblem<Real, Filter>;
  template <class T>
  static auto result(const auto& x) {
    return formula::entries<T>(x);
  }
};

struct Unfiltered {
  static constexpr const char* name = "stress derivative";
};

struct StressDerivative : FilteredStressDerivative<Unfiltered, fem::Unfiltered> {
  static constexpr const char* name = "stress_derivative";
  static constexpr int place = 1;

  template <class T, class Real>
  static elasticity::StressDerivative<T> naive(index_t i, const auto& svds) {
    return formula::stress_derivative<T, Real>(svds[i].s.template cast<T>());
  }
  template <class T>
  static Eigen::Matrix<T, 12, 1> observe(const auto& x) {
    return formula::entries<T>(x);
  }
};

struct Clamp {
  static constexpr const char* name = "clamped stress derivative";
  template <class T>
  static T value(T eigenvalue) {
    return eigenvalue < 0 ? T(0) : eigenvalue;
  }
};

struct StressDerivativeClamped : FilteredStressDerivative<Clamp, fem::ClampEigenvalues> {
  static constexpr const char* name = "stress_derivative_clamped";
  static constexpr int place = 35;
};

struct Absolute {
  static constexpr const char* name = "absolute stress derivative";
  template <class T>
  static T value(T eigenvalue) {
    return std::abs(eigenvalue);
  }
};

struct StressDerivativeAbsolute : FilteredStressDerivative<Absolute, fem::AbsoluteEigenvalues> {
  static constexpr const char* name = "stress_derivative_absolute";
  static constexpr int place = 36;
};

PHYSGEN_BENCH_ROWS(StressDerivative, OnScene OnSet);
PHYSGEN_BENCH_ROWS(StressDerivativeClamped, OnSet);
PHYSGEN_BENCH_ROWS(StressDerivativeAbsolute, OnSet);

}  // namespace physgen::bench
