#include <fem/mesh/refine.h>
#include <fem/mesh/rings.h>
#include <fem/solver/hierarchy/check_parents.h>
#include <fem/solver/hierarchy/galerkin_block.h>
#include <fem/solver/hierarchy/graph_lists.h>
#include <fem/solver/hierarchy/grid_graph.h>
#include <fem/solver/hierarchy/hierarchy.h>
#include <physgen/error.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace physgen::fem {

namespace {

using detail::EdgeNumbers;
using detail::Lists;
using detail::ordered;
using detail::Pair;
using detail::sort_unique;

std::vector<Pair> patch_pairs(const VolumePatches& patches) {
  std::vector<Pair> pairs;
  for (std::size_t p = 0; p < patches.nodes.size(); ++p) {
    const auto count = static_cast<std::size_t>(patches.node_counts[p]);
    for (std::size_t a = 0; a < count; ++a) {
      for (std::size_t b = a + 1; b < count; ++b) pairs.push_back(ordered(patches.nodes[p][a], patches.nodes[p][b]));
    }
  }
  return pairs;
}

/// Coarse pairs that P^T K P of these edges may fill.
void add_coarse_pairs(const std::vector<Pair>& edges, const std::vector<Pair>& parents, std::vector<Pair>& pairs) {
  const auto add = [&](Index a, Index b) {
    if (a != b) pairs.push_back(ordered(a, b));
  };
  for (const Pair& p : parents) add(p[0], p[1]);
  for (const auto& [a, b] : edges) {
    const Pair &p = parents[static_cast<std::size_t>(a)], &q = parents[static_cast<std::size_t>(b)];
    for (const Index i : p) {
      for (const Index j : q) add(i, j);
    }
  }
  sort_unique(pairs);
}

IncidenceList node_edges_of(Index nodes, const std::vector<Pair>& edges) {
  Lists lists(static_cast<std::size_t>(nodes));
  for (std::size_t e = 0; e < edges.size(); ++e) {
    lists.add(edges[e][0], static_cast<Index>(e), 0);
    lists.add(edges[e][1], static_cast<Index>(e), 1);
  }
  return lists.take();
}

/// The parts of P^T K P, each a quarter of a fine block; equal ones of one coarse block are joined.
void add_galerkin_terms(LevelGraph& fine, const LevelGraph& coarse) {
  const EdgeNumbers numbers(coarse.nodes, coarse.edges);
  Lists edges(coarse.edges.size());
  const auto code = [](GalerkinBlock kind, int quarters) { return static_cast<Index>(galerkin_code(kind, quarters)); };
  for (std::size_t a = 0; a < fine.parents.size(); ++a) {
    const auto [p, q] = fine.parents[a];
    const auto node = static_cast<Index>(a);
    if (p == q) continue;
    const Pair pair = ordered(p, q);
    edges.add(numbers.of(pair[0], pair[1]), node, code(GalerkinBlock::node, 1));
  }
  for (std::size_t e = 0; e < fine.edges.size(); ++e) {
    const Pair& p = fine.parents[static_cast<std::size_t>(fine.edges[e][0])];
    const Pair& q = fine.parents[static_cast<std::size_t>(fine.edges[e][1])];
    const int p_count = p[0] == p[1] ? 1 : 2, q_count = q[0] == q[1] ? 1 : 2;
    const int quarters = 4 / (p_count * q_count);
    for (int i = 0; i < p_count; ++i) {
      for (int j = 0; j < q_count; ++j) {
        const Index A = p[static_cast<std::size_t>(i)], B = q[static_cast<std::size_t>(j)];
        const auto edge = static_cast<Index>(e);
        if (A == B) continue;  // of a coarse node: from its edges
        const Pair pair = ordered(A, B);
        edges.add(numbers.of(pair[0], pair[1]), edge,
                  code(A < B ? GalerkinBlock::edge : GalerkinBlock::reverse, quarters));
      }
    }
  }
  fine.edge_terms = edges.take();
}

/// The parts of P^T K P on a background grid: which fine blocks have any.
void add_grid_terms(LevelGraph& fine, const LevelGraph& coarse) {
  const EdgeNumbers numbers(coarse.nodes, coarse.edges);
  Lists edges(coarse.edges.size());
  const auto add = [&](Index a, Index b, Index element, GalerkinBlock kind) {
    detail::for_each_grid_pair(
        fine.grid_parents[static_cast<std::size_t>(a)], fine.grid_parents[static_cast<std::size_t>(b)],
        [&](Index A, Index B) { edges.add(numbers.of(A, B), element, static_cast<Index>(galerkin_code(kind, 1))); });
  };
  for (Index a = 0; a < fine.nodes; ++a) add(a, a, a, GalerkinBlock::node);
  for (std::size_t e = 0; e < fine.edges.size(); ++e) {
    add(fine.edges[e][0], fine.edges[e][1], static_cast<Index>(e), GalerkinBlock::edge);
  }
  fine.edge_terms = edges.take();
}

}  // namespace

double mean_spacing(const TetMesh& mesh, const std::vector<Point>& rest) {
  double six_volumes = 0;
  for (const auto& tet : mesh.tets) {
    const auto at = [&](std::size_t c, std::size_t k) {
      return rest[std::size_t(tet[c])][k] - rest[std::size_t(tet[0])][k];
    };
    six_volumes += std::abs(at(1, 0) * (at(2, 1) * at(3, 2) - at(2, 2) * at(3, 1)) +
                            at(1, 1) * (at(2, 2) * at(3, 0) - at(2, 0) * at(3, 2)) +
                            at(1, 2) * (at(2, 0) * at(3, 1) - at(2, 1) * at(3, 0)));
  }
  return std::cbrt(six_volumes / double(mesh.tets.size()));
}

std::vector<LevelGraph> make_level_graphs(const std::vector<MeshLevel>& levels, bool edges) {
  std::vector<LevelGraph> graphs(levels.size());
  std::vector<Pair> inherited;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const MeshLevel& level = levels[l];
    LevelGraph& graph = graphs[l];
    graph.nodes = level.mesh.nodes;
    graph.is_grid = level.is_grid();
    graph.fixed = level.fixed;
    const auto size = static_cast<std::size_t>(graph.nodes);
    if (level.fixed.size() != size || level.rest.size() != size) {
      throw Error("level " + std::to_string(l) + " has " + std::to_string(size) + " nodes, but " +
                  std::to_string(level.rest.size()) + " positions and " + std::to_string(level.fixed.size()) +
                  " constraints");
    }
    if (edges) {
      graph.edges = std::move(inherited);
      graph.edges.insert(graph.edges.end(), level.mesh.edges.begin(), level.mesh.edges.end());
      const std::vector<Pair> pairs =
          level.averages_at_nodes ? pairs_in_rings(make_rings(level.mesh)) : patch_pairs(level.patches);
      graph.edges.insert(graph.edges.end(), pairs.begin(), pairs.end());
      sort_unique(graph.edges);
      graph.node_edges = node_edges_of(graph.nodes, graph.edges);
    }
    if (l + 1 == levels.size()) break;
    Lists children(static_cast<std::size_t>(levels[l + 1].mesh.nodes));
    if (!level.grid_parents.empty()) {
      detail::check_parents(l, level, levels[l + 1], level.grid_parents);
      graph.grid_parents = level.grid_parents;
      for (std::size_t a = 0; a < size; ++a) {
        const auto& [nodes, weights] = graph.grid_parents[a];
        for (std::size_t k = 0; edges && k < 4; ++k) {
          if (weights[k] != 0) children.add(nodes[k], static_cast<Index>(a), static_cast<Index>(k));
        }
      }
    } else {
      detail::check_parents(l, level, levels[l + 1], level.parents);
      graph.parents = level.parents;
      for (std::size_t a = 0; edges && a < size; ++a) {
        const auto [p, q] = graph.parents[a];
        children.add(p, static_cast<Index>(a), p == q ? 2 : 1);
        if (p != q) children.add(q, static_cast<Index>(a), 1);
      }
    }
    if (!edges) continue;
    graph.children = children.take();
    inherited.clear();
    if (graph.grid_parents.empty()) {
      add_coarse_pairs(graph.edges, graph.parents, inherited);
    } else {
      inherited = detail::grid_pairs(graph.edges, graph.grid_parents);
    }
  }
  for (std::size_t l = 0; edges && l + 1 < graphs.size(); ++l) {
    if (graphs[l].grid_parents.empty()) {
      add_galerkin_terms(graphs[l], graphs[l + 1]);
    } else {
      add_grid_terms(graphs[l], graphs[l + 1]);
    }
  }
  return graphs;
}

EdgeParts make_edge_parts(const MeshLevel& level, const LevelGraph& graph) {
  const EdgeNumbers numbers(graph.nodes, graph.edges);
  Lists tets(graph.edges.size()), patches(graph.edges.size());
  for (std::size_t e = 0; e < level.mesh.edges.size(); ++e) {
    const Index edge = numbers.of(level.mesh.edges[e][0], level.mesh.edges[e][1]);
    for (auto k = static_cast<std::size_t>(level.mesh.edge_tets.first[e]);
         k < static_cast<std::size_t>(level.mesh.edge_tets.first[e + 1]); ++k) {
      tets.add(edge, level.mesh.edge_tets.entries[k].element, level.mesh.edge_tets.entries[k].local);
    }
  }
  for (std::size_t p = 0; p < level.patches.nodes.size(); ++p) {
    const auto& nodes = level.patches.nodes[p];
    const Index count = level.patches.node_counts[p];
    for (Index a = 0; a < count; ++a) {
      for (Index b = 0; b < count; ++b) {
        const Index m = nodes[static_cast<std::size_t>(a)], n = nodes[static_cast<std::size_t>(b)];
        if (m < n) patches.add(numbers.of(m, n), static_cast<Index>(p), a + 8 * b);
      }
    }
  }
  return {tets.take(), patches.take()};
}

IncidenceList make_node_patches(const MeshLevel& level) {
  Lists patches(static_cast<std::size_t>(level.mesh.nodes));
  for (std::size_t p = 0; p < level.patches.nodes.size(); ++p) {
    for (Index slot = 0; slot < level.patches.node_counts[p]; ++slot) {
      patches.add(level.patches.nodes[p][static_cast<std::size_t>(slot)], static_cast<Index>(p), slot);
    }
  }
  return patches.take();
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
    level.rest.reserve(static_cast<std::size_t>(level.mesh.nodes));
    const auto at = [&](Index k) { return side * (double(k) / double(n)); };
    for (Index z = 0; z <= n; ++z) {
      for (Index y = 0; y <= n; ++y) {
        for (Index x = 0; x <= n; ++x) level.rest.push_back({at(x), at(y), at(z)});
      }
    }
    level.fixed.assign(level.rest.size(), 0);
    if (patches) level.patches = cell_patches(level.mesh);
    const bool last = n == last_cells;
    if (!last) {
      level.parents = box_parents(n / 2, n / 2, n / 2, mirrored(n / 2));
      const Index half = n / 2;
      for (Index c = 0; patches && c < n * n * n; ++c) {
        level.patch_parents.push_back(c % n / 2 + half * (c / n % n / 2 + half * (c / n / n / 2)));
      }
    }
    levels.push_back(std::move(level));
    if (last) return levels;
  }
}

}  // namespace physgen::fem
