// What one of several ranks has lists of: of the levels of a box the layers of cells that it needs, as levels of a box
// of their own, so that no rank makes the lists of the whole; of other meshes all.
#pragma once

#include <fem/mesh/mesh.h>
#include <fem/solver/hierarchy/hierarchy.h>
#include <fem/solver/hierarchy/level_graph.h>
#include <fem/solver/mesh_level.h>
#include <fem/solver/settings.h>
#include <physgen/distributed/named_objects.h>
#include <physgen/distributed/runs.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace physgen::fem {

/// Coarser levels of so many nodes, those of a cube of 36^3 cells, stand on every rank.
inline constexpr index_t replicated_nodes = 50653;

/// The number of levels that are cut: the finest, and meshes below it that have more nodes than `replicated`, or by
/// themselves than replicated_nodes, and eight blocks a rank. None that is inverted as a whole. @param graphs finest
/// first
[[nodiscard]] inline std::size_t levels_that_are_cut(std::span<const LevelGraph> graphs, int ranks,
                                                     std::optional<index_t> replicated = {}) {
  const index_t most = std::max<index_t>(most_coarse_nodes,
                                         replicated.value_or(std::max(replicated_nodes, 8 * Runs::block * ranks - 1)));
  std::size_t cut = 1;
  const auto is_large = [most](const LevelGraph& graph) { return !graph.is_grid && graph.nodes > most; };
  while (cut < graphs.size() && is_large(graphs[cut])) ++cut;
  return cut;
}

/// The same of the levels that a solver uses, as its settings say.
/// @param nodes of each level, finest first; 0 of a background grid
[[nodiscard]] std::size_t levels_cut_by_solver(std::span<const index_t> nodes, const SolverSettings& settings,
                                               int ranks, std::optional<index_t> replicated);

/// Objects of one kind that lists have: object k of a list is number offset + k of all.
struct ListedObjects {
  index_t size = 0;  ///< of all
  index_t offset = 0;
  KnownObjects known = {};  ///< by numbers of all: of these the lists say what those of the whole say

  [[nodiscard]] index_t here(index_t number) const { return number - offset; }
};

/// Those of a level.
struct ListedLevel {
  ListedObjects nodes, edges, tets, patches;
};
/// Of a graph that is whole; tets and patches are not known of it.
[[nodiscard]] inline ListedLevel listed_whole(const LevelGraph& graph) {
  return {{index_t{graph.nodes}}, {static_cast<index_t>(graph.edges.size())}, {}, {}};
}

/// Those of levels; none where all are whole.
struct ListedLevels {
  std::vector<ListedLevel> levels;
  std::vector<ListedLevel> coarser;  ///< what the rows of a graph have of the next coarser level

  [[nodiscard]] ListedLevel of(std::size_t l, const LevelGraph& graph) const {
    return levels.empty() ? listed_whole(graph) : levels[l];
  }
  [[nodiscard]] ListedLevel coarser_of(std::size_t l, const LevelGraph& graph_of_coarser) const {
    return coarser.empty() ? listed_whole(graph_of_coarser) : coarser[l];
  }
};

/// What a rank has of levels.
struct PartOfLevels {
  std::vector<MeshLevel> levels;  ///< of a box: the layers of those that are cut, and of the next coarser; else none
  std::vector<LevelGraph> graphs;
  ListedLevels listed;
};

/// @param levels finest first. Where they are of a box (make_box_mesh(), box_parents(), and cell_patches() or none), of
/// those that are cut only tets, positions, constraints, parents and the nodes of patches are read, and no lists
/// @param cut the finest so many are cut
/// @param edges as make_level_graphs() takes it
/// @throw Error as make_level_graphs(), and where lists are missing that it needs
[[nodiscard]] PartOfLevels part_of_levels(std::span<const MeshLevel> levels, std::size_t cut, int rank, int ranks,
                                          bool edges = true);

}  // namespace physgen::fem
