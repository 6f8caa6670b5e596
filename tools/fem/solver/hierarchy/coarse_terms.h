// P^T K P of a level, P being the interpolation from the next coarser one: which coarse nodes it connects, and which
// fine blocks each coarse block consists of.
#pragma once

#include <fem/solver/hierarchy/level_graph.h>

#include <optional>

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
/// @param box LevelGraph::box of the coarse level
[[nodiscard]] CoarsePairs coarse_pairs(const LevelGraph& fine, Index coarse_nodes, const std::optional<BoxCells>& box);

/// Where the terms of each coarse edge begin, and the last ones end.
/// @pre the coarser level has its edges, `pairs` among them
/// @throw Error when there are more than 2^31 - 1
[[nodiscard]] HostList<Index> rows_of_terms(const CoarsePairs& pairs, const LevelGraph& coarse);

}  // namespace physgen::fem::detail
