// P^T K P of a level, P being the interpolation from the next coarser one: which coarse nodes it connects, and which
// fine blocks each coarse block consists of.
#pragma once

#include <fem/solver/hierarchy/level_graph.h>

namespace physgen::fem::detail {

/// Per coarse node: higher coarse nodes that P^T K P connects it with, and how many terms their block has.
struct CoarsePairs {
  struct Pair {
    Index other, terms;
  };
  HostList<Index> first;  ///< one more than there are coarse nodes
  HostList<Pair> pairs;
};

/// @pre the level has its edges and its children
[[nodiscard]] CoarsePairs coarse_pairs(const LevelGraph& fine, Index coarse_nodes);

/// The terms of each coarse edge: first those of fine nodes, then those of fine edges, both ascending.
/// @pre the coarser level has its edges, `pairs` among them
[[nodiscard]] IncidenceList coarse_terms(const LevelGraph& fine, const CoarsePairs& pairs, const LevelGraph& coarse);

}  // namespace physgen::fem::detail
