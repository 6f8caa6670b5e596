// The lists that the solver needs of its meshes, plain ones on the host: the graph of nodes and edges of each level,
// how a level hangs on the next coarser one, and what each coarse block of stiffness consists of.
#pragma once

#include <fem/solver/hierarchy/level_graph.h>
#include <fem/solver/mesh_level.h>

#include <functional>
#include <span>
#include <vector>

namespace physgen::fem {

/// A coarsest level of at most so many nodes is solved by a dense inverse, a larger one is smoothed.
inline constexpr Index most_coarse_nodes = 125;

/// The side of a cube as large as the six tets that a node has on average: about the distance of neighbours [m].
[[nodiscard]] double mean_spacing(const TetMesh& mesh, const std::vector<Point>& rest);

/// Rows of a graph over entries that a mesh has.
struct MeshRows {
  HostList<Index> first;
  std::span<const IncidenceEntry> entries;
};
/// The terms of the edges of the finest level, or of any level on which equilibrium is solved.
struct EdgeParts {
  MeshRows edge_tets;          ///< per edge: tet, local edge + 6 if it runs from n to m
  IncidenceList edge_patches;  ///< per edge: patch, slot of m + 8 slot of n
};

/// Graphs of all levels, finest first.
/// @param edges whether there are any; else nodes, constraints and parents alone
/// @throw Error when parents do not fit the coarser mesh, sizes differ, or a list would exceed 2^31 entries
[[nodiscard]] std::vector<LevelGraph> make_level_graphs(std::span<const MeshLevel> levels, bool edges = true);

/// The same but the entries of LevelGraph::edge_terms, the longest lists of all, which can be counted by their rows.
[[nodiscard]] std::vector<LevelGraph> make_counted_graphs(std::span<const MeshLevel> levels, bool edges = true);

/// Takes the terms that stand from entry `begin` of LevelGraph::edge_terms on. It is called from several threads.
using PutTerms = std::function<void(Index begin, std::span<const IncidenceEntry> terms)>;
/// Finds all entries of fine.edge_terms, of each row first those of fine nodes and then those of fine edges, both
/// ascending. @pre the rows are known
void each_edge_terms(const LevelGraph& fine, const LevelGraph& coarse, const PutTerms& put);

/// @pre the graph is that of the mesh, which lives as long as its parts are used
[[nodiscard]] EdgeParts make_edge_parts(const MeshLevel& level, const LevelGraph& graph);

/// Per node: patch, slot.
[[nodiscard]] IncidenceList make_node_patches(const MeshLevel& level);

/// The cube of cells^3 cells in levels of half as many cells each, as long as the number is even and above `coarsest`,
/// half of them mirrored along each axis, so that it drifts to no side; of an odd number on the coarsest level, one
/// more.
/// @param side [m]; base in the plane z = 0, corner in the origin
/// @throw Error as make_box_mesh() does
[[nodiscard]] std::vector<MeshLevel> make_cube_levels(Index cells, double side, bool patches, Index coarsest = 2);

}  // namespace physgen::fem
