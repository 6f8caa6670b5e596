// Force differentials: of each tet, matrix-free, before the sums at the nodes; and df = K dx over the nodes, from the
// assembled blocks of nodes and edges.
#pragma once

#include <fem/kernels/force_differential.h>

#include "kernels/stiffness.h"

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

struct AddForceDifferential {
  static constexpr const char* name = "add_force_differential";
  static constexpr int place = 2;
  static constexpr Domain domain = Domain::nodes;
  using Output = elasticity::NodeForceDifferentialObject;
  using Reads = Operands<Streamed<OutputOf<NodeStiffness>>, Streamed<OutputOf<EdgeStiffness>>, Streamed<source::Edges>,
                         Gathered<source::Ranges<Domain::nodes, Domain::node_edges>, Aos>,
                         Gathered<source::Entries<Domain::node_edges>, Aos>, Gathered<source::Displacements>>;
  using Writes = Operands<Gathered<source::Of<Output, domain>>>;
  template <class Real>
  static auto run(const auto& nodes, const auto& blocks, const auto& edges, const auto& ranges, const auto& entries,
                  const auto& displacements, const auto& out) {
    return fem::ComputeForceDifferentials{nodes,         blocks, edges, Rows{ranges, entries, edges.size()},
                                          displacements, out};
  }

  template <class T, class Real>
  static elasticity::NodeForceDifferential<T> naive(index_t i, const auto& node_stiffness, const auto& edge_stiffness,
                                                    const auto& edges, const auto& ranges, const auto& entries,
                                                    const auto& displacements) {
    Vector3<T> sum = node_stiffness[i].K.template cast<T>() * displacements[i].dx.template cast<T>();
    for (index_t k = ranges[i].begin; k < ranges[i].end; ++k) {
      const index_t edge = entries[k].element;
      const int side = entries[k].local;
      const Matrix3<T> E = edge_stiffness[edge].E.template cast<T>();
      const Vector3<T> dx = displacements[edges[edge].nodes[1 - side]].dx.template cast<T>();
      sum += side == 0 ? Vector3<T>(E * dx) : Vector3<T>(E.transpose() * dx);
    }
    return {sum};
  }
  template <class T>
  static Vector3<T> observe(const auto& value) {
    return value.df.template cast<T>();
  }
};

PHYSGEN_BENCH_ROWS(ElementForceDifferential, OnScene);
PHYSGEN_BENCH_ROWS(AddForceDifferential, OnScene);

}  // namespace physgen::bench
