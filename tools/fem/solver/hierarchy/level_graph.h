// A level as its stiffness has it: nodes, edges, and how it hangs on the next coarser one.
#pragma once

#include <fem/solver/mesh_level.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace physgen::fem {

/// The nodes and edges of a level as its stiffness has them, and the way to the next coarser level.
struct LevelGraph {
  Index nodes = 0;
  bool is_grid = false;
  EdgeList edges;            ///< those of tets, patches, rings and finer levels
  IncidenceList node_edges;  ///< edge, side
  std::vector<std::uint8_t> fixed;

  // To the next coarser level; empty on the coarsest.
  std::vector<std::array<Index, 2>> parents;
  std::vector<GridLocation> grid_parents;  ///< in place of `parents`
  /// Per coarse node: fine node, how many of its two parents are this node; or which of its grid parents is.
  IncidenceList children;
  /// Per coarse edge: fine node or edge, galerkin_code(); of a grid with one quarter, since weights are looked up. Of a
  /// graph that is counted its rows are known, and not yet their entries.
  IncidenceList edge_terms;
  /// Where the edges, and those of all finer levels, are found to repeat from cell to cell of a box: its cells. Then
  /// the parents of the next finer level's nodes do so, too.
  std::optional<BoxCells> box = std::nullopt;
};

}  // namespace physgen::fem
