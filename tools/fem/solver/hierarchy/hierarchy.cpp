#include <fem/mesh/refine.h>
#include <fem/mesh/rings.h>
#include <fem/mesh/stages.h>
#include <fem/solver/hierarchy/check_parents.h>
#include <fem/solver/hierarchy/coarse_terms.h>
#include <fem/solver/hierarchy/hierarchy.h>
#include <fem/solver/hierarchy/node_rows.h>
#include <physgen/error.h>

#include <cmath>
#include <optional>
#include <string>

namespace physgen::fem {

namespace {

using detail::CoarsePairs;
using detail::first_edges;
using detail::HigherNodes;
using physgen::detail::for_each_index;

void require_sizes(std::size_t l, const MeshLevel& level) {
  const std::size_t size = at(level.mesh.nodes);
  if (level.fixed.size() == size && level.rest.size() == size) return;
  throw Error("level " + std::to_string(l) + " has " + std::to_string(size) + " nodes, but " +
              std::to_string(level.rest.size()) + " positions and " + std::to_string(level.fixed.size()) +
              " constraints");
}

/// The edges of a level: those of its tets, of nodes that share a mean volume, and those that finer levels have.
EdgeList edges_of(const MeshLevel& level, const CoarsePairs& of_finer) {
  InStage stage("edges of levels");
  const bool patches = !level.patches.nodes.empty(), rings = level.averages_at_nodes;
  if (!patches && !rings && of_finer.pairs.empty()) return level.mesh.edges;
  const HostList<Index> first = first_edges(level.mesh.nodes, level.mesh.edges);
  const IncidenceList node_patches = patches ? make_node_patches(level) : IncidenceList();
  const NodeRings node_rings = rings ? make_rings(level.mesh) : NodeRings();
  struct Scratch {
    HigherNodes nodes;
    std::optional<HigherInRings> in_rings;
  };
  HostList<Index> first_of_all;
  EdgeList edges;
  append_rows(
      Host{}, level.mesh.nodes,
      [&] {
        Scratch scratch{HigherNodes(level.mesh.nodes), std::nullopt};
        if (rings) scratch.in_rings.emplace(level.mesh.nodes);
        return scratch;
      },
      [&](index_t m, Scratch& scratch, std::vector<std::array<Index, 2>>& row) {
        const auto node = static_cast<Index>(m);
        HigherNodes& higher = scratch.nodes;
        higher.begin(node);
        for (Index e = first[at(m)]; e < first[at(m) + 1]; ++e) higher.add(level.mesh.edges[at(e)][1]);
        for (Index k = patches ? node_patches.first[at(m)] : 0; patches && k < node_patches.first[at(m) + 1]; ++k) {
          const Index patch = node_patches.entries[at(k)].element;
          for (Index slot = 0; slot < level.patches.node_counts[at(patch)]; ++slot) {
            higher.add(level.patches.nodes[at(patch)][at(slot)]);
          }
        }
        if (rings) {
          scratch.in_rings->find(node_rings, node);
          for (const Index n : scratch.in_rings->nodes()) higher.add(n);
        }
        if (!of_finer.pairs.empty()) {
          for (Index k = of_finer.first[at(m)]; k < of_finer.first[at(m) + 1]; ++k) {
            higher.add(of_finer.pairs[at(k)].other);
          }
        }
        for (const Index n : higher.sorted()) row.push_back({node, n});
      },
      first_of_all, edges);
  stage.moves(level.mesh.edges, node_patches.entries, level.patches.nodes, node_rings.nodes, of_finer.pairs, edges);
  return edges;
}

IncidenceList children_of(const LevelGraph& graph, Index coarse_nodes) {
  InStage stage("children");
  IncidenceList children;
  fill_rows(
      Host{}, coarse_nodes, graph.nodes,
      [&graph](index_t a, const auto& put) {
        const auto node = static_cast<Index>(a);
        if (!graph.grid_parents.empty()) {
          const auto& [nodes, weights] = graph.grid_parents[at(a)];
          for (Index k = 0; k < 4; ++k) {
            if (weights[at(k)] != 0) put(nodes[at(k)], IncidenceEntry{node, k});
          }
          return;
        }
        const auto [p, q] = graph.parents[at(a)];
        put(p, IncidenceEntry{node, p == q ? 2 : 1});
        if (p != q) put(q, IncidenceEntry{node, 1});
      },
      children.first, children.entries);
  stage.moves(graph.parents, graph.grid_parents, children.first, children.entries);
  return children;
}

}  // namespace

double mean_spacing(const TetMesh& mesh, const std::vector<Point>& rest) {
  InStage stage("checks of tets");
  stage.moves(mesh.tets, rest);
  HostList<double> volumes(mesh.tets.size());
  for_each_index<4>(0, static_cast<index_t>(mesh.tets.size()), [&](index_t t) {
    const auto& tet = mesh.tets[at(t)];
    const auto side = [&](std::size_t c, std::size_t k) { return rest[at(tet[c])][k] - rest[at(tet[0])][k]; };
    volumes[at(t)] = std::abs(side(1, 0) * (side(2, 1) * side(3, 2) - side(2, 2) * side(3, 1)) +
                              side(1, 1) * (side(2, 2) * side(3, 0) - side(2, 0) * side(3, 2)) +
                              side(1, 2) * (side(2, 0) * side(3, 1) - side(2, 1) * side(3, 0)));
  });
  double six_volumes = 0;
  for (const double volume : volumes) six_volumes += volume;
  return std::cbrt(six_volumes / double(mesh.tets.size()));
}

std::vector<LevelGraph> make_level_graphs(std::span<const MeshLevel> levels, bool edges) {
  std::vector<LevelGraph> graphs(levels.size());
  CoarsePairs of_finer;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const MeshLevel& level = levels[l];
    LevelGraph& graph = graphs[l];
    require_sizes(l, level);
    graph.nodes = level.mesh.nodes;
    graph.is_grid = level.is_grid();
    graph.fixed = level.fixed;
    if (edges) {
      graph.edges = edges_of(level, of_finer);
      graph.node_edges = edges_of_nodes(graph.nodes, graph.edges);
      if (l > 0) graphs[l - 1].edge_terms = detail::coarse_terms(graphs[l - 1], of_finer, graph);
    }
    if (l + 1 == levels.size()) break;
    if (level.grid_parents.empty()) {
      detail::check_parents(l, level, levels[l + 1], level.parents);
      graph.parents = level.parents;
    } else {
      detail::check_parents(l, level, levels[l + 1], level.grid_parents);
      graph.grid_parents = level.grid_parents;
    }
    if (!edges) continue;
    graph.children = children_of(graph, levels[l + 1].mesh.nodes);
    of_finer = detail::coarse_pairs(graph, levels[l + 1].mesh.nodes);
  }
  return graphs;
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
      if (e < own[at(node) + 1] && level.mesh.edges[at(e)] == graph.edges[at(k)]) ++e;
    }
  });
  stage.moves(level.mesh.edges, graph.edges, level.mesh.edge_tets.entries, parts.edge_tets.entries,
              parts.edge_tets.first);
  const VolumePatches& patches = level.patches;
  if (patches.nodes.empty()) {
    parts.edge_patches.first.resize(graph.edges.size() + 1);
    for_each_index(0, static_cast<index_t>(graph.edges.size()) + 1,
                   [&](index_t e) { parts.edge_patches.first[at(e)] = 0; });
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

IncidenceList make_node_patches(const MeshLevel& level) {
  InStage stage("rows of patches");
  const VolumePatches& patches = level.patches;
  IncidenceList list;
  fill_rows(
      Host{}, level.mesh.nodes, static_cast<index_t>(patches.nodes.size()),
      [&patches](index_t p, const auto& put) {
        for (Index slot = 0; slot < patches.node_counts[at(p)]; ++slot) {
          put(patches.nodes[at(p)][at(slot)], IncidenceEntry{static_cast<Index>(p), slot});
        }
      },
      list.first, list.entries);
  stage.moves(patches.nodes, list.first, list.entries);
  return list;
}

std::vector<MeshLevel> make_cube_levels(Index cells, double side, bool patches, Index coarsest) {
  std::vector<MeshLevel> levels;
  Index last_cells = cells;
  while (last_cells > 0 && last_cells % 2 == 0 && last_cells / 2 >= coarsest) last_cells /= 2;
  const auto mirrored = [=](Index n) {  // the same places on all levels
    const Index from = last_cells < 1 ? 0 : n / last_cells * (last_cells / 2);
    return MirroredFrom{from, from, from};
  };
  for (Index n = cells;; n /= 2) {
    MeshLevel level;
    level.mesh = make_box_mesh(n, n, n, mirrored(n));
    level.rest.resize(at(level.mesh.nodes));
    const auto place = [&](index_t k) { return side * (double(k) / double(n)); };
    for_each_index<4>(0, level.mesh.nodes, [&](index_t node) {
      const index_t row = n + 1;
      level.rest[at(node)] = {place(node % row), place(node / row % row), place(node / (row * row))};
    });
    level.fixed.assign(level.rest.size(), 0);
    if (patches) level.patches = cell_patches(level.mesh);
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
