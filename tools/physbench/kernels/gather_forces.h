// The force on each node: the sum over its tets.
#pragma once

#include "kernels/elastic_force.h"

namespace physgen::bench {

struct GatherForces {
  static constexpr const char* name = "gather_forces";
  static constexpr int place = 7;
  static constexpr Domain domain = Domain::nodes;
  using Output = elasticity::NodeForceObject;
  using Reads = Operands<Gathered<source::Ranges<Domain::nodes, Domain::node_tets>, Aos>,
                         Gathered<source::Entries<Domain::node_tets>, Aos>, Streamed<OutputOf<ElasticForce>>>;
  using Writes = Operands<Gathered<source::Of<Output, domain>>>;
  template <class Real>
  static auto run(const auto& ranges, const auto& entries, const auto& forces, const auto& out) {
    return fem::GatherForces{Rows{ranges, entries, forces.size()}, forces, out};
  }

  template <class T, class Real>
  static elasticity::NodeForce<T> naive(index_t i, const auto& ranges, const auto& entries, const auto& forces) {
    Vector3<T> sum = Vector3<T>::Zero();
    for (index_t k = ranges[i].begin; k < ranges[i].end; ++k) {
      sum += formula::force_on<T>(forces[entries[k].element], entries[k].local);
    }
    return {sum};
  }
  template <class T>
  static Vector3<T> observe(const auto& value) {
    return value.f.template cast<T>();
  }
};

PHYSGEN_BENCH_ROWS(GatherForces, OnScene);

}  // namespace physgen::bench
