// The force differential on nodes, matrix-free, by one kernel over the tets, which adds to the nodes: what
// matrix_free_separate does in two. The order of sums is open.
#pragma once

#include <fem/kernels/groups.h>

#include "kernels/matrix_free_separate.h"

namespace physgen::bench {

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

PHYSGEN_BENCH_ROWS(MatrixFreeFused, OnScene);

}  // namespace physgen::bench
