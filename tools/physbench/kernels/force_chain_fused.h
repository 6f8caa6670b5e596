// Leads from positions to the forces on nodes by one kernel over the tets, which adds to the nodes: what
// force_chain_separate does in five. The order of sums is open.
#pragma once

#include <fem/kernels/groups.h>

#include "kernels/force_chain_separate.h"

namespace physgen::bench {

/// Rows of nodes are read by the reference alone.
struct ForceChainFused : ForceChainSeparate {
  static constexpr const char* name = "force_chain_fused";
  static constexpr int place = 13;
  using Writes = Operands<Gathered<source::Of<Output, domain>>>;
  template <class Real>
  static auto run(const auto& tets, const auto& positions, const auto& rest, const auto& /*ranges*/,
                  const auto& /*entries*/, const auto& forces) {
    return chain(link(forces.size(), fem::ClearNodes{forces}),
                 link(tets.size(), fem::fuse_added_forces(material<Real>(), tets, positions, rest, forces)));
  }
};

PHYSGEN_BENCH_ROWS(ForceChainFused, OnScene);

}  // namespace physgen::bench
