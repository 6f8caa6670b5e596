// Levels whose lists repeat from cell to cell of a box: how that is found, and what touches nodes there. For
// level_graphs.cpp, coarse_terms.cpp and hierarchy.cpp.
#pragma once

#include <fem/mesh/alike_nodes.h>
#include <fem/mesh/box_lists.h>
#include <fem/mesh/refine.h>
#include <fem/solver/hierarchy/node_rows.h>
#include <fem/solver/mesh_level.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <optional>
#include <span>
#include <vector>

namespace physgen::fem::detail {

/// How far nodes of a level see that lie alike in all that their edges, and the terms of blocks of theirs, depend on.
/// An edge of a mesh depends on the cells beside its lower node. The children of a node lie in the cells beside it,
/// their edges may begin one fine cell farther below, and what those depend on is at most one cell of this level
/// farther: two cells on each side. What depends as far on the next finer level reaches no farther on this one.
inline constexpr Index reach_of_edges = 2;

/// Whether the edges of a mesh are those of neighbours, and alike for nodes of its box beside which cells are alike.
[[nodiscard]] inline bool has_repeated_edges(const TetMesh& mesh) {
  if (!is_box_of(*mesh.box, mesh.nodes) || mesh.edges.empty()) return false;
  const AlikeNodes nodes(*mesh.box, 1);
  const auto first_of = [&mesh](Index node) {
    return std::ranges::lower_bound(mesh.edges, node, {}, [](const auto& edge) { return edge[0]; }) -
           mesh.edges.begin();
  };
  struct Row {
    index_t first, end;
  };
  std::vector<Row> of_kinds;
  for (index_t kind = 0; kind < nodes.kinds(); ++kind) {
    const Index node = nodes.first(kind);
    const Row row{first_of(node), first_of(node + 1)};
    for (index_t e = row.first; e < row.end; ++e) {
      const auto from = place_of(*mesh.box, node), to = place_of(*mesh.box, mesh.edges[at(e)][1]);
      for (std::size_t k = 0; k < 3; ++k) {
        if (std::abs(from[k] - to[k]) > 1) return false;
      }
    }
    of_kinds.push_back(row);
  }
  std::atomic<bool> repeats = true;
  const auto count = static_cast<index_t>(mesh.edges.size());
  nodes.each_row(first_of, [&](const AlikeNodes::Node& node, index_t& next) {
    const Row& row = of_kinds[at(node.kind)];
    const Index beyond = nodes.nodes_beyond(node);
    bool is_alike = next + (row.end - row.first) <= count;
    for (index_t e = row.first; is_alike && e < row.end; ++e) {
      const auto& [m, n] = mesh.edges[at(next++)];
      is_alike = m == node.number && n == mesh.edges[at(e)][1] + beyond;
    }
    is_alike &= next == count || (next < count && mesh.edges[at(next)][0] > node.number);
    if (!is_alike) repeats = false;
  });
  return repeats;
}

/// Whether the patches of a level are the cells of its mesh's box, as cell_patches() makes them.
[[nodiscard]] inline bool has_cell_patches(const MeshLevel& level) {
  const VolumePatches& patches = level.patches;
  if (!level.mesh.box) return false;
  const auto& [nx, ny, nz] = level.mesh.box->cells;
  const index_t rows = index_t{ny} * nz;
  if (static_cast<index_t>(patches.nodes.size()) != nx * rows || patches.node_counts.size() != patches.nodes.size()) {
    return false;
  }
  const Index row = nx + 1, layer = row * (ny + 1);
  std::atomic<bool> has_all = true;
  for_each_index<64>(0, rows, [&, nx = nx, ny = ny](index_t r) {
    const auto first = static_cast<Index>(r % ny) * row + static_cast<Index>(r / ny) * layer;
    bool is_same = true;
    for (Index x = 0; x < nx; ++x) {
      const std::size_t p = at(r * nx + x);
      is_same &= patches.node_counts[p] == 8;
      for (Index c = 0; c < 8; ++c) {
        is_same &= patches.nodes[p][at(c)] == first + x + (c & 1) + row * (c >> 1 & 1) + layer * (c >> 2);
      }
    }
    if (!is_same) has_all = false;
  });
  return has_all;
}

/// Whether a box has twice as many cells, mirrored in the same places, and nodes have the parents of box_parents().
[[nodiscard]] inline bool has_parents_of_box(const BoxCells& fine, const BoxCells& coarse,
                                             std::span<const std::array<Index, 2>> parents) {
  const auto is_twice = [](Index a, Index b) {
    return a == MirroredFrom::none || b == MirroredFrom::none ? a == b : a == 2 * index_t{b};
  };
  const MirroredFrom &of_fine = fine.mirrored, &of_coarse = coarse.mirrored;
  for (std::size_t k = 0; k < 3; ++k) {
    if (fine.cells[k] != 2 * index_t{coarse.cells[k]}) return false;
  }
  const index_t row = fine.cells[0] + 1, column = fine.cells[1] + 1, rows = column * (fine.cells[2] + 1);
  if (!is_twice(of_fine.x, of_coarse.x) || !is_twice(of_fine.y, of_coarse.y) || !is_twice(of_fine.z, of_coarse.z) ||
      static_cast<index_t>(parents.size()) != row * rows) {
    return false;
  }
  std::atomic<bool> has_all = true;
  for_each_index<64>(0, rows, [&](index_t r) {
    const auto y = static_cast<Index>(r % column), z = static_cast<Index>(r / column);
    bool is_same = true;
    for (Index x = 0; x < row; ++x) {
      const auto& [p, q] = parents[at(r * row + x)];
      const std::array<Index, 2> expected = box_parents_at(coarse, {x, y, z});
      is_same &= p == expected[0] && q == expected[1];
    }
    if (!is_same) has_all = false;
  });
  return has_all;
}

/// LevelGraph::box of a level. @param finer the next finer level, and LevelGraph::box of it; null where there is none
[[nodiscard]] inline std::optional<BoxCells> repeated_box(const MeshLevel& level, const MeshLevel* finer,
                                                          const std::optional<BoxCells>& box_of_finer) {
  InStage stage("checks of boxes");
  const std::optional<BoxCells>& box = level.mesh.box;
  if (!box || level.averages_at_nodes || (finer != nullptr && !box_of_finer)) return std::nullopt;
  if (!has_repeated_edges(level.mesh)) return std::nullopt;
  stage.moves(level.mesh.edges);
  if (!level.patches.nodes.empty()) {
    if (!has_cell_patches(level)) return std::nullopt;
    stage.moves(level.patches.nodes, level.patches.node_counts);
  }
  if (finer == nullptr) return box;
  stage.moves(finer->parents);
  if (!finer->grid_parents.empty() || !has_parents_of_box(*box_of_finer, *box, finer->parents)) return std::nullopt;
  return box;
}

/// append_rows() of the nodes of a level, of a box by the first nodes that lie alike.
/// @param move as move_rows() takes it
template <class Entry, class MakeScratch, class Visit, class Move>
void rows_of_nodes(const std::optional<BoxCells>& box, index_t nodes, const MakeScratch& make_scratch,
                   const Visit& visit, const Move& move, HostList<Index>& first, HostList<Entry>& entries) {
  if (!box) return append_rows(Host{}, nodes, make_scratch, visit, first, entries);
  const AlikeNodes alike(*box, reach_of_edges);
  move_rows(
      alike, make_scratch, visit,
      [&](const Entry& entry, const AlikeNodes::Node& node) { return move(entry, alike.nodes_beyond(node)); }, first,
      entries);
}

}  // namespace physgen::fem::detail
