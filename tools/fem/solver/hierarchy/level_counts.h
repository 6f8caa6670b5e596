// How many objects the levels of a solver have, and the entries of their lists: what decides the size of every array.
// It is counted of levels that are made, or forecast for those that are not.
#pragma once

#include <fem/solver/hierarchy/hierarchy.h>

#include <cstdint>
#include <span>
#include <vector>

namespace physgen::fem {

/// Numbers of the graph of a level.
struct GraphCounts {
  std::int64_t nodes = 0, edges = 0;  ///< edges are those of the stiffness
  // To the next coarser level; 0 on the coarsest.
  std::int64_t children = 0, edge_terms = 0;
  std::int64_t grid_parents = 0;  ///< nodes with parents in a background grid: all or none
  bool is_grid = false;           ///< of a background grid, which has no tets
  bool operator==(const GraphCounts&) const = default;
};
/// The same of its mesh.
struct LevelCounts : GraphCounts {
  std::int64_t tets = 0;
  std::int64_t tet_edges = 0;                  ///< edges of tets alone
  std::int64_t patches = 0, edge_patches = 0;  ///< volume patches; pairs of an edge and a patch that has it
  std::int64_t node_patches = 0;               ///< pairs of a node and a patch that has it
  std::int64_t patch_parents = 0;              ///< patches with parents on the next coarser level: all or none
  std::int64_t ring_nodes = 0;                 ///< of the rings of all nodes, where volumes are averaged at nodes
  bool operator==(const LevelCounts&) const = default;
};

[[nodiscard]] GraphCounts counts_of(const LevelGraph& graph);
[[nodiscard]] LevelCounts counts_of(const MeshLevel& level, const LevelGraph& graph);

/// Counts of given levels and their graphs, which are whole or those of make_counted_graphs().
[[nodiscard]] std::vector<LevelCounts> count_levels(std::span<const MeshLevel> levels,
                                                    std::span<const LevelGraph> graphs);
/// The same where the graphs are not wanted. Takes about a third of the solver's set-up.
[[nodiscard]] std::vector<LevelCounts> count_levels(const std::vector<MeshLevel>& levels);

}  // namespace physgen::fem
