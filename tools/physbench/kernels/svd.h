// The SVD of the deformation gradient, F = U diag(s) V^T, and what errors of an SVD are, whole or in part.
#pragma once

#include <fem/kernels/compute_svd.h>

#include "data/problem.h"
#include "kernels/deformation_gradient.h"

namespace physgen::bench {

/// Those parts that a kernel gives.
template <class T>
struct SvdParts {
  std::optional<Matrix3<T>> U;
  std::optional<Vector3<T>> s;
  std::optional<Matrix3<T>> V;
  std::optional<Matrix3<T>> R;  ///< U V^T
};

/// The error of an SVD is the largest of these that its parts allow:
///   |s - s_ref|max / s1;
///   |U S V^T - F| / |F|; of V and s alone |(F V)^T (F V) - S^2| / (2 s1^2), of U and s likewise with F^T;
///   |R - R_ref| times its condition (s2 + s3) / s1, at most 1 (Kenney and Laub 1991).
/// Norms are Frobenius. s may be off by a smallest subnormal.
template <class Real>
struct SvdProblem {
  using T = Wider<Real>;
  struct Input {
    Matrix3<Real> F;
  };
  using Reference = elasticity::DeformationSvd<T>;
  using Result = SvdParts<T>;

  static constexpr const char* name = "svd";
  static constexpr std::size_t numbers = 9;
  static constexpr const char* words = "9 numbers, F by columns";
  static std::vector<Input> inputs(InputSet set, index_t count) {
    std::vector<Input> made;
    for (const auto& F : deformations<Real>(set, count, 0, std::numeric_limits<double>::infinity()))
      made.push_back({F});
    return made;
  }
  static Input read(const Real* numbers) { return {matrix_of(numbers)}; }
  static std::vector<Real> write(const Input& input) { return named("F", input.F).numbers; }
  static auto values(const Input& input) { return std::make_tuple(elasticity::DeformationGradient<Real>{input.F}); }

  static Reference reference(const Input& input) { return formula::svd<T>(input.F.template cast<T>()); }
  static Result exact(const Reference& svd) { return {svd.U, svd.s, svd.V, svd.U * svd.V.transpose()}; }

  static InputErrors errors(const Input& input, const Reference& reference, const Result& result) {
    const T eps = std::numeric_limits<Real>::epsilon(), smallest = std::numeric_limits<Real>::denorm_min();
    const Matrix3<T> F = input.F.template cast<T>();
    const T norm = F.norm(), unit = norm == 0 ? T(1) : 1 / norm;
    const T s1 = reference.s[0] == 0 ? T(1) : reference.s[0];
    // Not std::max, which may lose a NaN.
    const auto beyond = [&](T error) { return error < smallest ? T(0) : error - smallest; };
    const auto& [U, s, V, R] = result;
    T error = 0;
    if (s) raise(error, beyond((*s - reference.s).cwiseAbs().template maxCoeff<Eigen::PropagateNaN>()) / s1);
    if (U && s && V) raise(error, beyond((*U * s->asDiagonal() * V->transpose() - F).norm()) * unit);
    if (s && !(U && V)) {
      const Matrix3<T> scaled = F * unit;
      const Vector3<T> squares = (*s * unit).cwiseAbs2();
      const auto off = [&](const Matrix3<T>& columns) {
        const Matrix3<T> square = columns.transpose() * columns - Matrix3<T>(squares.asDiagonal());
        const T error = square.norm() / (2 * (s1 * unit) * (s1 * unit));
        return error < smallest / s1 ? T(0) : error - smallest / s1;
      };
      if (V) raise(error, off(scaled * *V));
      if (U) raise(error, off(scaled.transpose() * *U));
    }
    if (R) {
      const T condition = std::min(T(1), (reference.s[1] + reference.s[2]) / s1);
      raise(error, T((*R - reference.U * reference.V.transpose()).norm() * condition));
    }
    InputErrors errors{static_cast<double>(error / eps), std::nullopt};
    for (const auto& Q : {U, V, R}) {
      if (!Q) continue;
      const Matrix3<T> product = Q->transpose() * *Q - Matrix3<T>::Identity();
      T orthogonality = product.cwiseAbs().template maxCoeff<Eigen::PropagateNaN>();
      raise(orthogonality, std::abs(Q->determinant() - 1));
      double worst = errors.orthogonality.value_or(0);
      raise(worst, static_cast<double>(orthogonality / eps));
      errors.orthogonality = worst;
    }
    return errors;
  }

  static std::vector<Named<T>> name_all(const Result& result) {
    std::vector<Named<T>> all;
    if (result.U) all.push_back(named("U", *result.U));
    if (result.s) all.push_back(named("s", *result.s));
    if (result.V) all.push_back(named("V", *result.V));
    if (result.R) all.push_back(named("R", *result.R));
    return all;
  }
};

/// The base of all kernels that solve SvdProblem: they read F, and the last number counts scalars of an object that are
/// read and written.
struct OfSvd {
  static constexpr Domain domain = Domain::tets;
  using Reads = Operands<Streamed<OutputOf<DeformationGradient>>>;
  template <class Real>
  using Problem = SvdProblem<Real>;
};

/// With a number of sweeps; 4 is the usual one.
template <int kSweeps>
struct SvdOfSweeps : OfSvd {
  using Output = elasticity::DeformationSvdObject;
  using Writes = Operands<Streamed<source::Of<Output, Domain::tets>>>;
  template <class Real, class... View>
  static auto run(const View&... view) {
    return fem::ComputeSvd{view..., fem::Sweeps<kSweeps>{}};
  }
  template <class T>
  static auto result(const auto& svd) {
    return SvdParts<T>{svd.U.template cast<T>(), svd.s.template cast<T>(), svd.V.template cast<T>(), {}};
  }
};

struct Svd : SvdOfSweeps<4> {
  static constexpr const char* name = "svd";
  static constexpr int place = 4;

  template <class T, class Real>
  static elasticity::DeformationSvd<T> naive(index_t i, const auto& gradients) {
    return formula::svd<T>(gradients[i].F.template cast<T>());
  }
  /// U and V are not unique where stretches meet: compared are s, the rotation U V^T and F itself.
  template <class T>
  static Eigen::Matrix<T, 3, 7> observe(const auto& value) {
    const Matrix3<T> U = value.U.template cast<T>(), V = value.V.template cast<T>();
    const Vector3<T> s = value.s.template cast<T>();
    Eigen::Matrix<T, 3, 7> all;
    all << s, U * V.transpose(), U * s.asDiagonal() * V.transpose();
    return all;
  }
};

PHYSGEN_BENCH_ROWS(Svd, OnScene OnSet);

}  // namespace physgen::bench
