#include <fem/mesh/rings.h>
#include <fem/mesh/stages.h>
#include <fem/solver/hierarchy/box_levels.h>
#include <fem/solver/hierarchy/check_parents.h>
#include <fem/solver/hierarchy/coarse_terms.h>
#include <fem/solver/hierarchy/level_graphs.h>
#include <fem/solver/hierarchy/node_rows.h>
#include <physgen/error.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <optional>
#include <string>
#include <utility>

namespace physgen::fem {

namespace {

using detail::check_parents;
using detail::coarse_pairs;
using detail::CoarsePairs;
using detail::copy_of;
using detail::each_cell_of_node;
using detail::first_edges;
using detail::for_each_index;
using detail::HigherNodes;
using detail::patches_of_nodes;
using detail::place_of;
using detail::repeated_box;
using detail::rows_of_nodes;

void require_sizes(std::size_t l, const MeshLevel& level) {
  const std::size_t size = at(level.mesh.nodes);
  if (level.fixed.size() == size && level.rest.size() == size) return;
  throw Error("level " + std::to_string(l) + " has " + std::to_string(size) + " nodes, but " +
              std::to_string(level.rest.size()) + " positions and " + std::to_string(level.fixed.size()) +
              " constraints");
}

/// Whether a graph has the edges that sums of a level go by: of its tets, and of nodes that share a mean volume. Of the
/// edges in a ring one is looked for, between its lowest and its highest node: a graph made without rings lacks many.
bool has_edges_of(const LevelGraph& graph, const MeshLevel& level) {
  const TetMesh& mesh = level.mesh;
  const VolumePatches& patches = level.patches;
  const HostList<Index> first = first_edges(graph.nodes, graph.edges);
  std::atomic<bool> has_all = true;
  const auto require = [&](Index m, Index n) {
    const auto from_m = std::span(graph.edges).subspan(at(first[at(m)]), at(first[at(m) + 1] - first[at(m)]));
    if (m != n && !std::ranges::binary_search(from_m, std::array{m, n})) has_all = false;
  };
  for_each_index(0, static_cast<index_t>(mesh.edges.size()),
                 [&](index_t e) { require(mesh.edges[at(e)][0], mesh.edges[at(e)][1]); });
  for_each_index<16>(0, static_cast<index_t>(patches.nodes.size()), [&](index_t p) {
    const auto nodes = std::span(patches.nodes[at(p)]).first(at(patches.node_counts[at(p)]));
    for (std::size_t b = 1; b < nodes.size(); ++b) {
      for (std::size_t a = 0; a < b; ++a) require(std::min(nodes[a], nodes[b]), std::max(nodes[a], nodes[b]));
    }
  });
  for_each_index(0, level.averages_at_nodes ? mesh.nodes : 0, [&](index_t node) {
    const Index begin = mesh.node_edges.first[at(node)], end = mesh.node_edges.first[at(node) + 1];
    if (begin == end) return;
    const auto lowest = mesh.edges[at(mesh.node_edges.entries[at(begin)].element)][0];
    const auto highest = mesh.edges[at(mesh.node_edges.entries[at(end - 1)].element)][1];
    require(lowest, highest);
  });
  return has_all;
}

bool has_parents_of(const LevelGraph& graph, const MeshLevel& level) {
  const auto is_same = [](const GridLocation& a, const GridLocation& b) {
    return a.nodes == b.nodes && a.weights == b.weights;
  };
  if (!std::ranges::equal(graph.grid_parents, level.grid_parents, is_same)) return false;
  return !level.grid_parents.empty() || graph.parents == level.parents;
}

/// A graph has the edges, the constraints and the parents of when it was counted.
void require_graphs(std::span<const MeshLevel> levels, const std::vector<LevelGraph>& graphs) {
  InStage stage("checks of graphs");
  if (graphs.size() < levels.size()) {
    throw Error("SolverSettings::graphs has " + std::to_string(graphs.size()) + " graphs for " +
                std::to_string(levels.size()) + " levels; give those of make_counted_graphs() of these levels, once");
  }
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const bool has_nodes = graphs[l].nodes == levels[l].mesh.nodes && graphs[l].is_grid == levels[l].is_grid();
    const bool has_parents = l + 1 == levels.size() || has_parents_of(graphs[l], levels[l]);
    const char* const other = !has_nodes                            ? "nodes"
                              : graphs[l].fixed != levels[l].fixed  ? "constraints"
                              : !has_parents                        ? "parents"
                              : !has_edges_of(graphs[l], levels[l]) ? "edges"
                                                                    : nullptr;
    stage.moves(levels[l].mesh.edges, graphs[l].edges);
    if (other == nullptr) continue;
    throw Error("SolverSettings::graphs: the graph of level " + std::to_string(l) + " has other " + other +
                " than the level; make it again with make_counted_graphs() when the levels are complete");
  }
}

/// The edges of a level: those of its tets, of nodes that share a mean volume, and those that finer levels have.
/// @param first of its edges to higher nodes, per node; and one more
EdgeList edges_of(const MeshLevel& level, const CoarsePairs& of_finer, const std::optional<BoxCells>& box,
                  HostList<Index>& first_of_all) {
  InStage stage("edges of levels");
  const bool patches = !level.patches.nodes.empty(), rings = level.averages_at_nodes;
  const HostList<Index> first = first_edges(level.mesh.nodes, level.mesh.edges);
  const IncidenceList node_patches = patches && !box ? patches_of_nodes(level) : IncidenceList();
  const auto each_patch = [&](Index node, const auto& act) {
    if (box) return each_cell_of_node(*box, place_of(*box, node), act);
    for (Index k = node_patches.first[at(node)]; k < node_patches.first[at(node) + 1]; ++k) {
      act(node_patches.entries[at(k)].element, node_patches.entries[at(k)].local);
    }
  };
  const NodeRings node_rings = rings ? make_rings(level.mesh) : NodeRings();
  struct Scratch {
    HigherNodes nodes;
    std::optional<HigherInRings> in_rings;
  };
  EdgeList edges;
  rows_of_nodes(
      box, level.mesh.nodes,
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
        if (patches) {
          each_patch(node, [&](Index patch, Index /*slot*/) {
            for (Index slot = 0; slot < level.patches.node_counts[at(patch)]; ++slot) {
              higher.add(level.patches.nodes[at(patch)][at(slot)]);
            }
          });
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
      [](const std::array<Index, 2>& edge, Index beyond) { return std::array{edge[0] + beyond, edge[1] + beyond}; },
      first_of_all, edges);
  stage.moves(level.mesh.edges, node_patches.entries, level.patches.nodes, node_rings.nodes, of_finer.pairs, edges);
  return edges;
}

/// Edges and their rows. Those of tets alone are the mesh's own.
void put_edges(const MeshLevel& level, const CoarsePairs& of_finer, LevelGraph& graph) {
  if (!level.is_grid() && level.patches.nodes.empty() && !level.averages_at_nodes && of_finer.pairs.empty()) {
    InStage stage("edges of levels");
    graph.edges = copy_of(level.mesh.edges);
    graph.node_edges = {copy_of(level.mesh.node_edges.first), copy_of(level.mesh.node_edges.entries)};
    stage.moves(graph.edges, graph.edges, graph.node_edges.entries, graph.node_edges.entries);
    return;
  }
  HostList<Index> first;
  graph.edges = edges_of(level, of_finer, graph.box, first);
  graph.node_edges = graph.box ? detail::edges_of_box_nodes(*graph.box, detail::reach_of_edges, first, graph.edges)
                               : edges_of_nodes(graph.nodes, graph.edges);
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

std::vector<LevelGraph> make_counted_graphs(std::span<const MeshLevel> levels, bool edges) {
  std::vector<LevelGraph> graphs(levels.size());
  CoarsePairs of_finer;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const MeshLevel& level = levels[l];
    LevelGraph& graph = graphs[l];
    require_sizes(l, level);
    if (edges && l == 0) graph.box = repeated_box(level, nullptr, std::nullopt);
    graph.nodes = level.mesh.nodes;
    graph.is_grid = level.is_grid();
    graph.fixed = level.fixed;
    if (edges) {
      put_edges(level, of_finer, graph);
      if (l > 0) graphs[l - 1].edge_terms.first = detail::rows_of_terms(of_finer, graph);
    }
    if (l + 1 == levels.size()) break;
    if (level.grid_parents.empty()) {
      check_parents(l, level, levels[l + 1], level.parents);
      graph.parents = level.parents;
    } else {
      check_parents(l, level, levels[l + 1], level.grid_parents);
      graph.grid_parents = level.grid_parents;
    }
    if (!edges) continue;
    graph.children = children_of(graph, levels[l + 1].mesh.nodes);
    graphs[l + 1].box = repeated_box(levels[l + 1], &level, graph.box);
    of_finer = coarse_pairs(graph, levels[l + 1].mesh.nodes, graphs[l + 1].box);
  }
  return graphs;
}

std::vector<LevelGraph> make_level_graphs(std::span<const MeshLevel> levels, bool edges) {
  std::vector<LevelGraph> graphs = make_counted_graphs(levels, edges);
  for (std::size_t l = 0; edges && l + 1 < graphs.size(); ++l) {
    IncidenceList& list = graphs[l].edge_terms;
    list.entries.resize(at(list.first.back()));
    each_edge_terms(graphs[l], graphs[l + 1], [&list](Index begin, std::span<const IncidenceEntry> terms) {
      std::ranges::copy(terms, list.entries.begin() + begin);
    });
  }
  return graphs;
}

std::vector<LevelGraph> graphs_in_use(std::span<const MeshLevel> used, const SolverSettings& settings) {
  const bool edges = settings.newton.product == Product::assembled;
  if (!settings.graphs) return make_counted_graphs(used, edges);
  std::vector<LevelGraph> graphs = std::exchange(*settings.graphs, {});
  require_graphs(used, graphs);
  if (!edges) return make_counted_graphs(used, edges);
  graphs.resize(used.size());
  LevelGraph& coarsest = graphs.back();
  coarsest.parents = {};
  coarsest.grid_parents = {};
  coarsest.children = coarsest.edge_terms = {};
  return graphs;
}

}  // namespace physgen::fem
