#include <fem/mesh/refine.h>
#include <fem/mesh/stages.h>
#include <fem/solver/hierarchy/box_levels.h>
#include <fem/solver/hierarchy/cube_levels.h>
#include <fem/solver/hierarchy/hierarchy.h>
#include <fem/solver/hierarchy/node_rows.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace physgen::fem {

namespace {

using detail::first_edges;
using physgen::detail::for_each_index;

/// EdgeParts::edge_patches of patches that are the cells of a box.
/// @param first per node: the first of its edges to higher nodes; and one more
IncidenceList patches_of_box_edges(const BoxCells& box, std::span<const Index> first,
                                   std::span<const std::array<Index, 2>> edges) {
  const detail::AlikeNodes nodes(box, detail::reach_of_edges);
  return detail::lists_of_box_edges(
      nodes, first,
      [&](Index node, Index edge, const auto& act) {
        const std::array<Index, 3> other = detail::place_of(box, edges[at(edge)][1]);
        detail::each_cell_of_node(box, detail::place_of(box, node), [&](Index cell, Index slot) {
          detail::each_cell_of_node(box, other, [&](Index same, Index other_slot) {
            if (same == cell) act(IncidenceEntry{cell, slot + 8 * other_slot});
          });
        });
      },
      [&nodes](const IncidenceEntry& entry, const detail::AlikeNodes::Node& node) {
        return IncidenceEntry{entry.element + nodes.cells_beyond(node), entry.local};
      });
}

}  // namespace

double mean_spacing(const TetMesh& mesh, const std::vector<Point>& rest) {
  InStage stage("checks of tets");
  stage.moves(mesh.tets, rest);
  // A part of the volumes at a time, which caches hold; they are added one after the other.
  const auto tets = static_cast<index_t>(mesh.tets.size());
  HostList<double> volumes(at(std::min(tets, index_t{1} << 16)));
  double six_volumes = 0;
  for (index_t first = 0; first < tets; first += static_cast<index_t>(volumes.size())) {
    const index_t count = std::min(tets - first, static_cast<index_t>(volumes.size()));
    for_each_index<4>(0, count, [&](index_t k) {
      const auto& tet = mesh.tets[at(first + k)];
      const auto side = [&](std::size_t c, std::size_t axis) {
        return rest[at(tet[c])][axis] - rest[at(tet[0])][axis];
      };
      volumes[at(k)] = std::abs(side(1, 0) * (side(2, 1) * side(3, 2) - side(2, 2) * side(3, 1)) +
                                side(1, 1) * (side(2, 2) * side(3, 0) - side(2, 0) * side(3, 2)) +
                                side(1, 2) * (side(2, 0) * side(3, 1) - side(2, 1) * side(3, 0)));
    });
    for (index_t k = 0; k < count; ++k) six_volumes += volumes[at(k)];
  }
  return std::cbrt(six_volumes / double(mesh.tets.size()));
}

EdgeParts make_edge_parts(const MeshLevel& level, const LevelGraph& graph) {
  InStage stage("tets and patches of edges");
  EdgeParts parts;
  const Index nodes = graph.nodes;
  const HostList<Index> first = first_edges(nodes, graph.edges), own = first_edges(nodes, level.mesh.edges);
  // Edges ascend in both, so the tets of the mesh's edges follow each other as they do there.
  parts.edge_tets.entries = level.mesh.edge_tets.entries;
  parts.edge_tets.first.resize(graph.edges.size() + 1);
  parts.edge_tets.first.back() = level.mesh.edge_tets.first.back();
  for_each_index<8>(0, nodes, [&](index_t node) {
    Index e = own[at(node)];
    for (Index k = first[at(node)]; k < first[at(node) + 1]; ++k) {
      parts.edge_tets.first[at(k)] = level.mesh.edge_tets.first[at(e)];
      if (e < own[at(node) + 1] && level.mesh.edges[at(e)][1] == graph.edges[at(k)][1]) ++e;
    }
  });
  stage.moves(level.mesh.edges, graph.edges, level.mesh.edge_tets.first, parts.edge_tets.first);
  const VolumePatches& patches = level.patches;
  if (patches.nodes.empty()) {
    parts.edge_patches.first.resize(graph.edges.size() + 1);
    for_each_index(0, static_cast<index_t>(graph.edges.size()) + 1,
                   [&](index_t e) { parts.edge_patches.first[at(e)] = 0; });
    return parts;
  }
  if (graph.box && detail::has_cell_patches(level)) {
    parts.edge_patches = patches_of_box_edges(*graph.box, first, graph.edges);
    stage.moves(patches.nodes, parts.edge_patches.first, parts.edge_patches.entries);
    return parts;
  }
  const IncidenceList node_patches = make_node_patches(level);
  const auto each_pair = [&](Index node, const auto& act) {
    for (Index k = node_patches.first[at(node)]; k < node_patches.first[at(node) + 1]; ++k) {
      const auto [patch, a] = node_patches.entries[at(k)];
      for (Index b = 0; b < patches.node_counts[at(patch)]; ++b) {
        const Index other = patches.nodes[at(patch)][at(b)];
        if (other > node) act(other, IncidenceEntry{patch, a + 8 * b});
      }
    }
  };
  const auto scratch = [nodes] { return HostList<Index>(at(nodes)); };  // per node: a number of its edge
  HostList<Index>& begin = parts.edge_patches.first;
  begin.resize(graph.edges.size() + 1);
  begin.back() = 0;
  detail::each_node(nodes, scratch, [&](Index node, HostList<Index>& edge_of) {
    for (Index e = first[at(node)]; e < first[at(node) + 1]; ++e) {
      begin[at(e)] = 0;
      edge_of[at(graph.edges[at(e)][1])] = e;
    }
    each_pair(node, [&](Index other, IncidenceEntry /*entry*/) { ++begin[at(edge_of[at(other)])]; });
  });
  parts.edge_patches.entries.resize(at(exclusive_scan(Host{}, std::span(begin))));
  detail::each_node(nodes, scratch, [&](Index node, HostList<Index>& next) {
    for (Index e = first[at(node)]; e < first[at(node) + 1]; ++e) next[at(graph.edges[at(e)][1])] = begin[at(e)];
    each_pair(node,
              [&](Index other, IncidenceEntry entry) { parts.edge_patches.entries[at(next[at(other)]++)] = entry; });
  });
  stage.moves(node_patches.entries, patches.nodes, begin, parts.edge_patches.entries);
  return parts;
}

IncidenceList make_node_patches(const MeshLevel& level) { return detail::patches_of_nodes(level); }

std::vector<MeshLevel> make_cube_levels(Index cells, double side, bool patches, Index coarsest) {
  return make_cube_levels_without_lists(cells, side, patches, coarsest, 0);
}

std::vector<MeshLevel> make_cube_levels_without_lists(Index cells, double side, bool patches, Index coarsest,
                                                      std::size_t without_lists) {
  std::vector<MeshLevel> levels;
  Index last_cells = cells;
  while (last_cells > 0 && last_cells % 2 == 0 && last_cells / 2 >= coarsest) last_cells /= 2;
  const auto mirrored = [=](Index n) {  // the same places on all levels
    const Index from = last_cells < 1 ? 0 : n / last_cells * (last_cells / 2);
    return MirroredFrom{from, from, from};
  };
  for (Index n = cells;; n /= 2) {
    MeshLevel level;
    const bool has_lists = levels.size() >= without_lists;
    level.mesh = has_lists ? make_box_mesh(n, n, n, mirrored(n)) : detail::make_box_tets({{n, n, n}, mirrored(n)});
    level.rest.resize(at(level.mesh.nodes));
    const auto place = [&](index_t k) { return side * (double(k) / double(n)); };
    for_each_index<4>(0, level.mesh.nodes, [&](index_t node) {
      const index_t row = n + 1;
      level.rest[at(node)] = {place(node % row), place(node / row % row), place(node / (row * row))};
    });
    level.fixed.assign(level.rest.size(), 0);
    if (patches) level.patches = cell_patches(level.mesh);
    if (!has_lists) level.patches = {std::move(level.patches.nodes), std::move(level.patches.node_counts), {}, {}, {}};
    const bool last = n == last_cells;
    if (!last) {
      level.parents = box_parents(n / 2, n / 2, n / 2, mirrored(n / 2));
      const Index half = n / 2;
      if (patches) level.patch_parents.resize(level.patches.nodes.size());
      for_each_index<2>(0, static_cast<index_t>(level.patch_parents.size()), [&](index_t cell) {
        const auto c = static_cast<Index>(cell);
        level.patch_parents[at(cell)] = c % n / 2 + half * (c / n % n / 2 + half * (c / n / n / 2));
      });
    }
    levels.push_back(std::move(level));
    if (last) return levels;
  }
}

}  // namespace physgen::fem
