// The lists of a hierarchy, made in parallel, against sets and maps that are filled one entry after the other; on 1, 2
// and 16 threads.
#include <fem/mesh/rings.h>
#include <fem/solver/hierarchy/background_grid.h>
#include <fem/solver/hierarchy/galerkin_block.h>
#include <fem/solver/hierarchy/hierarchy.h>
#include <gtest/gtest.h>
#include <physgen/threads.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "../irregular.h"
#include "box_levels.h"

namespace physgen::fem {
namespace {

using Edge = std::array<Index, 2>;
using Lists = std::vector<std::vector<IncidenceEntry>>;

Edge ordered(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

IncidenceList listed(const Lists& lists) {
  IncidenceList list{{0}, {}};
  for (const auto& entries : lists) {
    list.entries.insert(list.entries.end(), entries.begin(), entries.end());
    list.first.push_back(static_cast<Index>(list.entries.size()));
  }
  return list;
}

/// A parent of a node, and which of its parents it is.
struct Parent {
  Index node;
  Index number;
};
std::vector<Parent> parents_of(const MeshLevel& level, Index node) {
  std::vector<Parent> parents;
  if (level.grid_parents.empty()) {
    const auto [p, q] = level.parents[at(node)];
    parents.push_back({p, 0});
    if (p != q) parents.push_back({q, 1});
    return parents;
  }
  for (Index k = 0; k < 4; ++k) {
    if (level.grid_parents[at(node)].weights[at(k)] != 0)
      parents.push_back({level.grid_parents[at(node)].nodes[at(k)], k});
  }
  return parents;
}

/// What a level is expected to have, made in the order in which its fine nodes and edges come.
struct Expected {
  std::vector<Edge> edges;
  Lists node_edges, children, edge_terms, edge_tets, edge_patches;
  std::set<Edge> coarse_pairs;
};

Expected expect_level(const MeshLevel& level, const std::set<Edge>& inherited) {
  Expected expected;
  std::set<Edge> edges = inherited;
  edges.insert(level.mesh.edges.begin(), level.mesh.edges.end());
  for (std::size_t p = 0; p < level.patches.nodes.size(); ++p) {
    for (Index a = 0; a < level.patches.node_counts[p]; ++a) {
      for (Index b = 0; b < a; ++b) edges.insert(ordered(level.patches.nodes[p][at(a)], level.patches.nodes[p][at(b)]));
    }
  }
  if (level.averages_at_nodes) {
    const auto pairs = pairs_in_rings(make_rings(level.mesh));
    edges.insert(pairs.begin(), pairs.end());
  }
  expected.edges.assign(edges.begin(), edges.end());
  std::map<Edge, std::size_t> numbers;
  expected.node_edges.resize(at(level.mesh.nodes));
  for (std::size_t e = 0; e < expected.edges.size(); ++e) {
    numbers[expected.edges[e]] = e;
    for (Index side = 0; side < 2; ++side) {
      expected.node_edges[at(expected.edges[e][at(side)])].push_back({static_cast<Index>(e), side});
    }
  }
  expected.edge_tets.resize(edges.size());
  expected.edge_patches.resize(edges.size());
  for (std::size_t e = 0; e < level.mesh.edges.size(); ++e) {
    for (Index k = level.mesh.edge_tets.first[e]; k < level.mesh.edge_tets.first[e + 1]; ++k) {
      expected.edge_tets[numbers.at(level.mesh.edges[e])].push_back(level.mesh.edge_tets.entries[at(k)]);
    }
  }
  for (std::size_t p = 0; p < level.patches.nodes.size(); ++p) {
    for (Index a = 0; a < level.patches.node_counts[p]; ++a) {
      for (Index b = 0; b < level.patches.node_counts[p]; ++b) {
        const Index m = level.patches.nodes[p][at(a)], n = level.patches.nodes[p][at(b)];
        if (m < n) expected.edge_patches[numbers.at({m, n})].push_back({static_cast<Index>(p), a + 8 * b});
      }
    }
  }
  return expected;
}

/// Children, coarse pairs, and then the terms, which need the edges of the coarser level.
void expect_parents(const MeshLevel& level, Index coarse_nodes, Expected& expected) {
  expected.children.resize(at(coarse_nodes));
  for (Index a = 0; a < level.mesh.nodes; ++a) {
    const auto parents = parents_of(level, a);
    for (const auto& [node, number] : parents) {
      const Index weight = level.grid_parents.empty() ? (parents.size() == 1 ? 2 : 1) : number;
      expected.children[at(node)].push_back({a, weight});
      for (const auto& other : parents) {
        if (other.node != node) expected.coarse_pairs.insert(ordered(node, other.node));
      }
    }
  }
  for (const auto& [a, b] : expected.edges) {
    for (const auto& p : parents_of(level, a)) {
      for (const auto& q : parents_of(level, b)) {
        if (p.node != q.node) expected.coarse_pairs.insert(ordered(p.node, q.node));
      }
    }
  }
}

void expect_terms(const MeshLevel& level, const std::vector<Edge>& coarse_edges, Expected& expected) {
  std::map<Edge, std::size_t> numbers;
  for (std::size_t e = 0; e < coarse_edges.size(); ++e) numbers[coarse_edges[e]] = e;
  expected.edge_terms.resize(coarse_edges.size());
  const bool grid = !level.grid_parents.empty();
  const auto add = [&](Index a, Index b, Index element, GalerkinBlock kind, int quarters) {
    expected.edge_terms[numbers.at(ordered(a, b))].push_back(
        {element, static_cast<Index>(galerkin_code(kind, quarters))});
  };
  for (Index a = 0; a < level.mesh.nodes; ++a) {
    std::set<Edge> pairs;
    for (const auto& p : parents_of(level, a)) {
      for (const auto& q : parents_of(level, a)) {
        if (p.node < q.node) pairs.insert({p.node, q.node});
      }
    }
    for (const auto& [p, q] : pairs) add(p, q, a, GalerkinBlock::node, 1);
  }
  for (std::size_t e = 0; e < expected.edges.size(); ++e) {
    const auto ps = parents_of(level, expected.edges[e][0]), qs = parents_of(level, expected.edges[e][1]);
    std::set<Edge> pairs;
    for (const auto& p : ps) {
      for (const auto& q : qs) {
        if (p.node == q.node || (grid && !pairs.insert(ordered(p.node, q.node)).second)) continue;
        const GalerkinBlock kind = grid || p.node < q.node ? GalerkinBlock::edge : GalerkinBlock::reverse;
        add(p.node, q.node, static_cast<Index>(e), kind, grid ? 1 : static_cast<int>(4 / (ps.size() * qs.size())));
      }
    }
  }
}

void expect_right_graphs(const std::vector<MeshLevel>& levels) {
  std::vector<Expected> expected;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    expected.push_back(expect_level(levels[l], l == 0 ? std::set<Edge>() : expected[l - 1].coarse_pairs));
    if (l > 0) expect_terms(levels[l - 1], expected[l].edges, expected[l - 1]);
    if (l + 1 < levels.size()) expect_parents(levels[l], levels[l + 1].mesh.nodes, expected[l]);
  }
  for (const int count : {1, 2, 16}) {
    SCOPED_TRACE(std::to_string(count) + " threads");
    set_threads(count);
    const std::vector<LevelGraph> graphs = make_level_graphs(levels);
    for (std::size_t l = 0; l < levels.size(); ++l) {
      SCOPED_TRACE("level " + std::to_string(l));
      EXPECT_EQ(graphs[l].edges, expected[l].edges);
      EXPECT_EQ(graphs[l].node_edges, listed(expected[l].node_edges));
      if (l + 1 < levels.size()) {
        EXPECT_EQ(graphs[l].children, listed(expected[l].children));
        EXPECT_EQ(graphs[l].edge_terms, listed(expected[l].edge_terms));
      }
      if (levels[l].is_grid()) continue;
      const EdgeParts parts = make_edge_parts(levels[l], graphs[l]);
      const IncidenceList edge_tets = listed(expected[l].edge_tets);
      EXPECT_EQ(parts.edge_tets.first, edge_tets.first);
      EXPECT_TRUE(std::ranges::equal(parts.edge_tets.entries, edge_tets.entries));
      EXPECT_EQ(parts.edge_patches, listed(expected[l].edge_patches));
    }
  }
  set_threads(0);
}

std::uint8_t free_node(const Point& /*x*/) { return 0; }

TEST(LevelGraphs, of_cubes_are_those_of_sets) {
  for (const Index cells : {1, 2, 3, 8, 12}) {
    expect_right_graphs(make_cube_levels(cells, 0.08, false));
    expect_right_graphs(make_cube_levels(cells, 0.08, true));
  }
  std::vector<MeshLevel> levels = make_cube_levels(8, 0.08, false);
  for (MeshLevel& level : levels) level.averages_at_nodes = true;
  expect_right_graphs(levels);
}

TEST(LevelGraphs, of_refined_irregular_meshes_are_those_of_sets) {
  const Tets tets = shuffled(irregular_box({2, 3, 2}, {1, 1, 1}, 0.2, 7), 8);
  for (const bool patches : {false, true}) expect_right_graphs(make_levels(tets, 2, patches, free_node));
}

TEST(LevelGraphs, over_background_grids_are_those_of_sets) {
  const Tets tets = shuffled(irregular_box({9, 10, 8}, {1, 1, 1}, 0.2, 9), 10);
  std::vector<MeshLevel> levels = make_levels(tets, 0, true, free_node);
  ASSERT_GT(add_background_grid(levels)[0], 0);
  expect_right_graphs(levels);
}

/// All lists of levels are those of the same levels that nothing says are boxes.
/// @param repeating how many of the finest levels are to be taken for boxes
void expect_same_without_boxes(const std::vector<MeshLevel>& levels, std::size_t repeating) {
  std::vector<MeshLevel> plain = levels;
  for (MeshLevel& level : plain) level.mesh.box.reset();
  set_threads(1);
  const std::vector<LevelGraph> expected = make_level_graphs(plain);
  for (const int count : {1, 2, 16}) {
    SCOPED_TRACE(std::to_string(count) + " threads");
    set_threads(count);
    const std::vector<LevelGraph> graphs = make_level_graphs(levels);
    for (std::size_t l = 0; l < levels.size(); ++l) {
      SCOPED_TRACE("level " + std::to_string(l));
      EXPECT_FALSE(expected[l].box.has_value());
      EXPECT_EQ(graphs[l].box.has_value(), l < repeating);
      EXPECT_EQ(graphs[l].edges, expected[l].edges);
      EXPECT_EQ(graphs[l].node_edges, expected[l].node_edges);
      EXPECT_EQ(graphs[l].children, expected[l].children);
      EXPECT_EQ(graphs[l].edge_terms, expected[l].edge_terms);
      const EdgeParts parts = make_edge_parts(levels[l], graphs[l]),
                      expected_parts = make_edge_parts(plain[l], expected[l]);
      EXPECT_EQ(parts.edge_tets.first, expected_parts.edge_tets.first);
      EXPECT_EQ(parts.edge_patches, expected_parts.edge_patches);
    }
  }
  set_threads(0);
}

TEST(LevelGraphs, of_cubes_by_formula_are_those_of_any_mesh) {
  for (const Index cells : {1, 2, 3, 4, 5, 6, 7, 9, 10, 14, 16, 20, 24}) {
    SCOPED_TRACE(std::to_string(cells) + " cells");
    for (const bool patches : {false, true}) {
      const auto levels = make_cube_levels(cells, 0.08, patches);
      expect_same_without_boxes(levels, levels.size());
    }
  }
}

TEST(LevelGraphs, of_boxes_by_formula_are_those_of_any_mesh) {
  constexpr Index none = MirroredFrom::none;
  for (const bool patches : {false, true}) {
    for (const auto& mirrored : {MirroredFrom{}, {1, 2, none}, {0, none, 3}, {3, 1, 1}}) {
      expect_same_without_boxes(box_levels({3, 2, 4}, mirrored, 2, patches), 3);
      expect_same_without_boxes(box_levels({1, 5, 2}, mirrored, 1, patches), 2);
    }
    expect_right_graphs(box_levels({3, 1, 2}, {1, none, 1}, 2, patches));
  }
}

TEST(LevelGraphs, of_meshes_that_only_look_like_boxes_are_found_among_their_tets) {
  for (const bool patches : {false, true}) {
    const std::vector<MeshLevel> levels = box_levels({6, 5, 7}, {3, 2, 4}, 1, patches);
    for (const std::size_t l : {0, 1}) {
      SCOPED_TRACE("level " + std::to_string(l));
      const auto expect_same = [&](std::size_t repeating, const auto& change) {
        std::vector<MeshLevel> changed = levels;
        change(changed[l]);
        expect_same_without_boxes(changed, repeating);
      };
      const auto expect_own_lists = [&](const auto& change_tets) {
        expect_same(l, [&](MeshLevel& level) {
          auto tets = level.mesh.tets;
          change_tets(tets);
          level.mesh = make_tet_mesh(level.mesh.nodes, tets);
          level.mesh.box = levels[l].mesh.box;
        });
      };
      const std::size_t size = levels[l].mesh.tets.size(), middle = size / 2 / 6 * 6;
      expect_own_lists([&](auto& tets) { tets.resize(size - 6); });
      expect_own_lists([&](auto& tets) { turn_cell(levels[l].mesh, middle, tets); });
      expect_same(l, [](MeshLevel& level) { level.mesh.box->mirrored.y += 1; });
      expect_same(l, [](MeshLevel& level) { std::swap(level.mesh.box->cells[0], level.mesh.box->cells[1]); });
      // As many nodes, by two counts below 0, whose loops visit nothing; and counts that none can have.
      const auto& [x, y, z] = levels[l].mesh.box->cells;
      expect_same(l, [x = x, y = y, z = z](MeshLevel& level) { level.mesh.box->cells = {-2 - x, -2 - y, z}; });
      expect_same(l, [](MeshLevel& level) { level.mesh.box->cells[2] = std::numeric_limits<Index>::max(); });
      expect_same(l, [](MeshLevel& level) { level.mesh.box->mirrored.z = std::numeric_limits<Index>::min(); });
      if (patches) {
        expect_same(l + 2, [](MeshLevel& level) { level.patches = {}; });
        expect_same(l, [](MeshLevel& level) { level.patches.node_counts[5] = 7; });
        expect_same(l, [](MeshLevel& level) { level.patches.nodes[7] = level.patches.nodes[6]; });
      }
      if (l == 1) continue;
      expect_same(1, [](MeshLevel& level) { std::swap(level.parents[20], level.parents[21]); });
      expect_same(1, [](MeshLevel& level) { level.parents.back()[0] -= 1; });
    }
  }
}

}  // namespace
}  // namespace physgen::fem
