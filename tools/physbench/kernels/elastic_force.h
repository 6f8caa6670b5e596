// The elastic forces of each tet on its corners, before the sums at the nodes.
#pragma once

#include <fem/kernels/elastic_force.h>

#include "kernels/stress.h"

namespace physgen::bench {

struct ElasticForce {
  static constexpr const char* name = "elastic_force";
  static constexpr int place = 6;
  static constexpr Domain domain = Domain::tets;
  using Output = elasticity::CornerForcesObject;
  using Reads = Operands<Streamed<source::RestShapes>, Streamed<OutputOf<Stress>>>;
  using Writes = Operands<Streamed<source::Of<Output, domain>>>;
  template <class Real, class... View>
  static auto run(const View&... view) {
    return fem::ComputeCornerForces{view...};
  }

  template <class T, class Real>
  static elasticity::CornerForces<T> naive(index_t i, const auto& rest, const auto& stresses) {
    return {formula::corner_forces<T>(rest[i], stresses[i].P.template cast<T>())};
  }
  template <class T>
  static Matrix3<T> observe(const auto& value) {
    return value.G.template cast<T>();
  }
};

PHYSGEN_BENCH_ROWS(ElasticForce, OnScene);

}  // namespace physgen::bench
