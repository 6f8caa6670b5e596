// dP from dF: the change of the stress along a change of the deformation gradient, and what its errors are.
#pragma once

#include <fem/kernels/stress_differential.h>

#include "kernels/stress_derivative.h"

namespace physgen::bench {

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

  static constexpr const char* name = "dP from dF";
  static constexpr std::size_t numbers = 18;
  static constexpr const char* words = "18 numbers, F by columns and dF by columns";
  static Input make(const Matrix3<Real>& F, const Matrix3<Real>& dF) {
    Input input{F, dF, rounded_svd<Real>(F), {}};
    const auto x = formula::stress_derivative<T, Real>(input.svd.s.template cast<T>());
    input.x = {Real(x.x1111), Real(x.x2211), Real(x.x3311), Real(x.x2222), Real(x.x3322), Real(x.x3333),
               Real(x.x2121), Real(x.x2112), Real(x.x3131), Real(x.x3113), Real(x.x3232), Real(x.x3223)};
    return input;
  }
  static std::vector<Input> inputs(InputSet set, index_t count) {
    const auto gradients = bounded_deformations<Real>(set, count);
    const auto changes = differentials<Real>(gradients);
    std::vector<Input> made(gradients.size());
    physgen::detail::host_loop(static_cast<index_t>(made.size()), [&](index_t k) {
      const auto i = static_cast<std::size_t>(k);
      made[i] = make(gradients[i], changes[i]);
    });
    return made;
  }
  static Input read(const Real* numbers) { return make(matrix_of(numbers), matrix_of(numbers + 9)); }
  static std::vector<Real> write(const Input& input) {
    std::vector<Real> all = named("F", input.F).numbers, more = named("dF", input.dF).numbers;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  static auto values(const Input& input) {
    return std::make_tuple(input.svd, input.x, elasticity::DeformationGradientDifferential<Real>{input.dF});
  }

  static Reference reference(const Input& input) {
    const Matrix3<T> dF = input.dF.template cast<T>();
    const T largest = formula::entries<T>(input.x).cwiseAbs().maxCoeff();
    return {formula::dp_from_df<T>(input.svd.U.template cast<T>(), input.svd.V.template cast<T>(), input.x, dF),
            largest * dF.norm()};
  }
  static Result exact(const Reference& reference) { return reference.dP; }

  static InputErrors errors(const Input& /*input*/, const Reference& reference, const Result& result) {
    const T scale = reference.scale == 0 ? T(1) : reference.scale;
    return {static_cast<double>((result - reference.dP).norm() / scale / std::numeric_limits<Real>::epsilon()), {}};
  }
  static std::vector<Named<T>> name_all(const Result& result) { return {named("dP", result)}; }
};

struct DpFromDf {
  static constexpr const char* name = "dp_from_df";
  static constexpr int place = 0;
  static constexpr Domain domain = Domain::tets;
  using Output = elasticity::StressDifferentialObject;
  using Reads =
      Operands<Streamed<OutputOf<Svd>>, Streamed<OutputOf<StressDerivative>>, Streamed<source::Differentials>>;
  using Writes = Operands<Streamed<source::Of<Output, domain>>>;
  template <class Real, class... View>
  static auto run(const View&... view) {
    return fem::ComputeStressDifferential{view...};
  }
  template <class Real>
  using Problem = DpFromDfProblem<Real>;
  template <class T>
  static auto result(const auto& stress) {
    return Eigen::Matrix<T, 3, 3>(stress.dP.template cast<T>());
  }

  template <class T, class Real>
  static elasticity::StressDifferential<T> naive(index_t i, const auto& svds, const auto& derivatives,
                                                 const auto& differentials) {
    const auto& svd = svds[i];
    return {formula::dp_from_df<T>(svd.U.template cast<T>(), svd.V.template cast<T>(), derivatives[i],
                                   differentials[i].dF.template cast<T>())};
  }
  template <class T>
  static Matrix3<T> observe(const auto& value) {
    return value.dP.template cast<T>();
  }
};

PHYSGEN_BENCH_ROWS(DpFromDf, OnScene OnSet);

}  // namespace physgen::bench
