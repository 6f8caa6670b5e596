// F = Ds Dm^-1 of each tet, from gathered nodes.
#pragma once

#include <fem/kernels/deformation_gradient.h>

#include "data/formulas.h"
#include "data/operands.h"

namespace physgen::bench {

struct DeformationGradient {
  static constexpr const char* name = "deformation_gradient";
  static constexpr int place = 3;
  static constexpr Domain domain = Domain::tets;
  using Output = elasticity::DeformationGradientObject;
  using Reads = Operands<Streamed<source::Tets>, Gathered<source::Positions>, Streamed<source::RestShapes>>;
  using Writes = Operands<Streamed<source::Of<Output, domain>>>;
  template <class Real, class... View>
  static auto run(const View&... view) {
    return fem::ComputeDeformationGradient{view...};
  }

  template <class T, class Real>
  static elasticity::DeformationGradient<T> naive(index_t i, const auto& tets, const auto& positions,
                                                  const auto& rest) {
    const Matrix3<T> ds = formula::edges<T>(tets[i].nodes, [&](index_t node) { return positions[node].x; });
    return {ds * rest[i].dm_inverse.template cast<T>()};
  }
  template <class T>
  static Matrix3<T> observe(const auto& value) {
    return value.F.template cast<T>();
  }
};

PHYSGEN_BENCH_ROWS(DeformationGradient, OnScene);

}  // namespace physgen::bench
