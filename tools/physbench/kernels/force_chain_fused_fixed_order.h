// The same in a fixed order: a kernel over the tets stores what they do at their corners in the rows of nodes, and one
// over the nodes sums the rows.
#pragma once

#include <fem/kernels/groups.h>

#include "kernels/force_chain_separate.h"

namespace physgen::bench {

/// Entries of rows are read by the reference alone.
struct ForceChainFusedFixedOrder : ForceChainSeparate {
  static constexpr const char* name = "force_chain_fused_fixed_order";
  static constexpr int place = 14;
  using Reads = Operands<Streamed<source::Tets>, Gathered<source::Positions>, Streamed<source::RestShapes>,
                         Gathered<source::Ranges<Domain::nodes, Domain::node_tets>, Aos>,
                         Gathered<source::Entries<Domain::node_tets>, Aos>, Streamed<source::TetPlaces>>;
  using Writes = Operands<Gathered<source::Of<elasticity::PlacedForceObject, Domain::node_tets>>,
                          Gathered<source::Of<Output, domain>>>;
  template <class Real>
  static auto run(const auto& tets, const auto& positions, const auto& rest, const auto& ranges,
                  const auto& /*entries*/, const auto& places, const auto& placed, const auto& forces) {
    const fem::SumRowForces sum{ranges, placed, forces};
    return chain(link(tets.size(), fem::fuse_placed_forces(material<Real>(), tets, positions, rest, places, placed)),
                 link(sum.size(), sum));
  }

  template <class T, class Real>
  static elasticity::NodeForce<T> naive(index_t i, const auto& tets, const auto& positions, const auto& rest,
                                        const auto& ranges, const auto& entries, const auto& /*places*/) {
    return ForceChainSeparate::naive<T, Real>(i, tets, positions, rest, ranges, entries);
  }
};

PHYSGEN_BENCH_ROWS(ForceChainFusedFixedOrder, OnScene);

}  // namespace physgen::bench
