// The force differential on nodes, matrix-free: by a kernel over the tets and a gather from what it stores, and by one
// kernel that does both.
#pragma once

#include <fem/kernels/groups.h>

#include "kernels/force_chain.h"
#include "kernels/force_differential.h"

namespace physgen::bench {

struct MatrixFreeSeparate {
  static constexpr const char* name = "matrix_free_separate";
  static constexpr int place = 17;
  static constexpr bool few_layouts = true;  ///< AoS and the schema's tiles
  static constexpr Domain domain = Domain::nodes;
  using Output = elasticity::NodeForceDifferentialObject;
  using Reads = Operands<Streamed<source::Tets>, Gathered<source::Displacements>, Streamed<source::RestShapes>,
                         Streamed<OutputOf<Svd>>, Streamed<OutputOf<StressDerivative>>,
                         Gathered<source::Ranges<Domain::nodes, Domain::node_tets>, Aos>,
                         Gathered<source::Entries<Domain::node_tets>, Aos>>;
  using Writes = Operands<Streamed<source::Of<ElementForceDifferential::Output, Domain::tets>>,
                          Gathered<source::Of<Output, domain>>>;
  template <class Real>
  static auto run(const auto& tets, const auto& displacements, const auto& rest, const auto& svds,
                  const auto& derivatives, const auto& ranges, const auto& entries, const auto& corners,
                  const auto& out) {
    const index_t n = tets.size();
    return chain(link(n, fem::ComputeCornerForceDifferentials{tets, displacements, rest, svds, derivatives, corners}),
                 link(out.size(), fem::GatherForceDifferentials{Rows{ranges, entries, n}, corners, out}));
  }

  template <class T, class Real>
  static elasticity::NodeForceDifferential<T> naive(index_t i, const auto& tets, const auto& displacements,
                                                    const auto& rest, const auto& svds, const auto& derivatives,
                                                    const auto& ranges, const auto& entries) {
    Vector3<T> sum = Vector3<T>::Zero();
    for (index_t k = ranges[i].begin; k < ranges[i].end; ++k) {
      sum += formula::force_on<T>(
          ElementForceDifferential::naive<T, Real>(entries[k].element, tets, displacements, rest, svds, derivatives),
          entries[k].local);
    }
    return {sum};
  }
  template <class T>
  static Vector3<T> observe(const auto& value) {
    return value.df.template cast<T>();
  }
};

/// Adds to the nodes. The order of sums is open.
/// Rows of nodes are read by the reference alone.
struct MatrixFreeFused : MatrixFreeSeparate {
  static constexpr const char* name = "matrix_free_fused";
  static constexpr int place = 18;
  using Writes = Operands<Gathered<source::Of<Output, domain>>>;
  template <class Real>
  static auto run(const auto& tets, const auto& displacements, const auto& rest, const auto& svds,
                  const auto& derivatives, const auto& /*ranges*/, const auto& /*entries*/, const auto& out) {
    return chain(link(out.size(), fem::ClearNodes{out}),
                 link(tets.size(), fem::fuse_added_differentials(tets, displacements, rest, svds, derivatives, out)));
  }
};

PHYSGEN_BENCH_ROWS(MatrixFreeSeparate, OnScene);
PHYSGEN_BENCH_ROWS(MatrixFreeFused, OnScene);

}  // namespace physgen::bench
