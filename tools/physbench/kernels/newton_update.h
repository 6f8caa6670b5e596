// Computes what a step of Newton's method needs of positions, corner forces and the tangent's parts: by five kernels,
// each of which stores what the next ones read, and by one that is fused of them.
#pragma once

#include <fem/kernels/groups.h>

#include "kernels/elastic_force.h"
#include "kernels/force_chain.h"
#include "kernels/stress_derivative.h"

namespace physgen::bench {

/// The values of a tet that are compared: its corner forces, and its stress differential along one change of F; both
/// over what they are like in size.
template <class T>
struct NewtonOfTet {
  Matrix3<T> U, V;
  elasticity::StressDerivative<T> derivative;
  Matrix3<T> G;

  [[nodiscard]] Eigen::Matrix<T, 3, 6> observed() const {
    const T mu = formula::Lame<T, double>().mu, edge = T(fem::TruthCube::side) / 100;
    Matrix3<T> dF;
    dF << T(0.3), T(-0.5), T(0.7), T(0.2), T(-0.4), T(0.6), T(0.9), T(0.1), T(-0.8);
    Eigen::Matrix<T, 3, 6> all;
    all << G / (mu * edge * edge), formula::dp_from_df<T>(U, V, derivative, dF) / mu;
    return all;
  }
};

struct NewtonUpdateSeparate {
  static constexpr const char* name = "newton_update_separate";
  static constexpr int place = 15;
  static constexpr bool few_layouts = true;  ///< AoS and the schema's tiles: its kernels have rows of their own
  static constexpr Domain domain = Domain::tets;
  using Derivative = StressDerivativeClamped;
  using Reads = Operands<Streamed<source::Tets>, Gathered<source::Positions>, Streamed<source::RestShapes>>;
  using Writes =
      Operands<Streamed<source::Of<DeformationGradient::Output, domain>>, Streamed<source::Of<Svd::Output, domain>>,
               Streamed<source::Of<Derivative::Output, domain>>, Streamed<source::Of<Stress::Output, domain>>,
               Streamed<source::Of<ElasticForce::Output, domain>>>;
  template <class Real>
  static auto run(const auto& tets, const auto& positions, const auto& rest, const auto& gradients, const auto& svds,
                  const auto& derivatives, const auto& stresses, const auto& corners) {
    const index_t n = tets.size();
    return chain(link(n, fem::ComputeDeformationGradient{tets, positions, rest, gradients}),
                 link(n, fem::ComputeSvd{gradients, svds}),
                 link(n, fem::ComputeStressDerivative{material<Real>(), svds, derivatives, fem::ClampEigenvalues{}}),
                 link(n, fem::ComputeStress{material<Real>(), svds, stresses}),
                 link(n, fem::ComputeCornerForces{rest, stresses, corners}));
  }

  template <class T, class Real>
  static NewtonOfTet<T> naive(index_t i, const auto& tets, const auto& positions, const auto& rest) {
    const auto svd = formula::svd<T>(DeformationGradient::naive<T, Real>(i, tets, positions, rest).F);
    const auto x = Derivative::Problem<Real>::filtered(formula::entries<T>(formula::stress_derivative<T, Real>(svd.s)));
    return {svd.U,
            svd.V,
            {x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], x[9], x[10], x[11]},
            formula::corner_forces<T>(rest[i], formula::stress<T, Real>(svd))};
  }
  template <class T>
  static auto observe(const NewtonOfTet<T>& tet) {
    return tet.observed();
  }
  template <class T>
  static auto observe(const auto& /*gradient*/, const auto& svd, const auto& derivative, const auto& /*stress*/,
                      const auto& corners) {
    return kept<T>(svd, derivative, corners);
  }

 protected:
  /// @param directions with U and V
  template <class T>
  static auto kept(const auto& directions, const auto& derivative, const auto& corners) {
    const auto x = formula::entries<T>(derivative);
    return NewtonOfTet<T>{directions.U.template cast<T>(),
                          directions.V.template cast<T>(),
                          {x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], x[9], x[10], x[11]},
                          corners.G.template cast<T>()}
        .observed();
  }
};

/// Corner forces, U, V and the derivative are kept.
struct NewtonUpdateFused : NewtonUpdateSeparate {
  static constexpr const char* name = "newton_update_fused";
  static constexpr int place = 16;
  using Writes =
      Operands<Streamed<source::Of<elasticity::PrincipalDirectionsObject, domain>>,
               Streamed<source::Of<Derivative::Output, domain>>, Streamed<source::Of<ElasticForce::Output, domain>>>;
  template <class Real>
  static auto run(const auto& tets, const auto& positions, const auto& rest, const auto& directions,
                  const auto& derivatives, const auto& corners) {
    return fem::fuse_newton_update(material<Real>(), tets, positions, rest, directions, derivatives, corners);
  }

  template <class T>
  static auto observe(const NewtonOfTet<T>& tet) {
    return tet.observed();
  }
  template <class T>
  static auto observe(const auto& directions, const auto& derivative, const auto& corners) {
    return kept<T>(directions, derivative, corners);
  }
};

PHYSGEN_BENCH_ROWS(NewtonUpdateSeparate, OnScene);
PHYSGEN_BENCH_ROWS(NewtonUpdateFused, OnScene);

}  // namespace physgen::bench
