// The change of each tet's corner forces along a displacement, matrix-free, before the sums at the nodes.
#pragma once

#include <fem/kernels/force_differential.h>

#include "kernels/stress_derivative.h"

namespace physgen::bench {

struct ElementForceDifferential {
  static constexpr const char* name = "element_force_differential";
  static constexpr int place = 11;
  static constexpr Domain domain = Domain::tets;
  using Output = elasticity::CornerForcesObject;
  using Reads = Operands<Streamed<source::Tets>, Gathered<source::Displacements>, Streamed<source::RestShapes>,
                         Streamed<OutputOf<Svd>>, Streamed<OutputOf<StressDerivative>>>;
  using Writes = Operands<Streamed<source::Of<Output, domain>>>;
  template <class Real, class... View>
  static auto run(const View&... view) {
    return fem::ComputeCornerForceDifferentials{view...};
  }

  template <class T, class Real>
  static elasticity::CornerForces<T> naive(index_t i, const auto& tets, const auto& displacements, const auto& rest,
                                           const auto& svds, const auto& derivatives) {
    const Matrix3<T> ds = formula::edges<T>(tets[i].nodes, [&](index_t node) { return displacements[node].dx; });
    const auto& svd = svds[i];
    const Matrix3<T> dF = ds * rest[i].dm_inverse.template cast<T>();
    const Matrix3<T> dP =
        formula::dp_from_df<T>(svd.U.template cast<T>(), svd.V.template cast<T>(), derivatives[i], dF);
    return {formula::corner_forces<T>(rest[i], dP)};
  }
  template <class T>
  static Matrix3<T> observe(const auto& value) {
    return value.G.template cast<T>();
  }
};

PHYSGEN_BENCH_ROWS(ElementForceDifferential, OnScene);

}  // namespace physgen::bench
