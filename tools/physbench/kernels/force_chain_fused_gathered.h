// The same, but corner forces are stored, and gathered by another kernel: what is fastest on a CPU. The order of sums
// is that of the separate kernels.
#pragma once

#include <fem/kernels/groups.h>

#include "kernels/force_chain_separate.h"

namespace physgen::bench {

struct ForceChainFusedGathered : ForceChainSeparate {
  static constexpr const char* name = "force_chain_fused_gathered";
  static constexpr int place = 19;
  using Writes =
      Operands<Streamed<source::Of<ElasticForce::Output, Domain::tets>>, Gathered<source::Of<Output, domain>>>;
  template <class Real>
  static auto run(const auto& tets, const auto& positions, const auto& rest, const auto& ranges, const auto& entries,
                  const auto& corners, const auto& forces) {
    return chain(link(tets.size(), fem::fuse_corner_forces(material<Real>(), tets, positions, rest, corners)),
                 link(forces.size(), fem::GatherForces{Rows{ranges, entries, tets.size()}, corners, forces}));
  }
};

PHYSGEN_BENCH_ROWS(ForceChainFusedGathered, OnScene);

}  // namespace physgen::bench
