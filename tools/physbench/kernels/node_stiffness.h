// The diagonal block of each node: the sum of its corners' blocks over its tets.
#pragma once

#include "kernels/gather_forces.h"
#include "kernels/tet_stiffness.h"

namespace physgen::bench {

struct NodeStiffness {
  static constexpr const char* name = "node_stiffness";
  static constexpr int place = 9;
  static constexpr Domain domain = Domain::nodes;
  using Output = elasticity::NodeStiffnessObject;
  using Reads = Operands<Gathered<source::Ranges<Domain::nodes, Domain::node_tets>, Aos>,
                         Gathered<source::Entries<Domain::node_tets>, Aos>, Streamed<OutputOf<TetStiffness>>>;
  using Writes = Operands<Streamed<source::Of<Output, domain>>>;
  template <class Real>
  static auto run(const auto& ranges, const auto& entries, const auto& tets, const auto& out) {
    return fem::GatherNodeStiffness{Rows{ranges, entries, tets.size()}, tets, out};
  }

  template <class T, class Real>
  static elasticity::NodeStiffness<T> naive(index_t i, const auto& ranges, const auto& entries, const auto& stiffness) {
    Matrix3<T> sum = Matrix3<T>::Zero();
    for (index_t k = ranges[i].begin; k < ranges[i].end; ++k) {
      sum += stiffness[entries[k].element].k[static_cast<std::size_t>(entries[k].local)].template cast<T>();
    }
    return {sum};
  }
  template <class T>
  static Matrix3<T> observe(const auto& value) {
    return Matrix3<T>(value.K.template cast<T>().template selfadjointView<Eigen::Lower>());  // what is stored
  }
};

PHYSGEN_BENCH_ROWS(NodeStiffness, OnScene);

}  // namespace physgen::bench
