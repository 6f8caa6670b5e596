// Graphs of all levels, one after the other, for what is made or counted of how each hangs on the next.
#pragma once

#include <fem/solver/hierarchy/coarse_terms.h>
#include <fem/solver/hierarchy/level_graph.h>

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace physgen::fem::detail {

/// Called when the edges of a coarser level l are known, with the graphs up to there, and the pairs of its nodes that
/// level l - 1 connects.
using AtCoarse = std::function<void(std::size_t l, std::vector<LevelGraph>& graphs, const CoarsePairs& pairs)>;

/// Graphs of all levels, finest first, without LevelGraph::edge_terms.
/// @param edges whether there are any; else nodes, constraints and parents alone
/// @throw Error when parents do not fit the coarser mesh, sizes differ, or a list would exceed 2^31 entries
[[nodiscard]] std::vector<LevelGraph> make_graphs(std::span<const MeshLevel> levels, bool edges,
                                                  const AtCoarse& at_coarse);

}  // namespace physgen::fem::detail
