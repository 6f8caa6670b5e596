// Blocks and supernodes of the Schwarz preconditioner on irregular meshes, and where pieces stay apart.
#include <fem/solver/preconditioners/schwarz/schwarz_hierarchy.h>
#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <set>

#include "../bonded.h"

namespace physgen::fem {
namespace {

TEST(SchwarzHierarchy, every_free_node_stands_in_one_slot_and_supernodes_are_connected_within_one_block) {
  const std::vector<MeshLevel> cases[] = {irregular(), bonded(irregular_box({16, 16, 16}, {1, 1, 1}, 0, 1))};
  for (const auto& levels : cases) {
    const LevelGraph graph = make_level_graphs(levels).front();
    const SchwarzHierarchy h = make_schwarz_hierarchy(graph, levels[0].rest);
    std::set<Index> taken;
    for (Index n = 0; n < graph.nodes; ++n) {
      const Index slot = h.node_slots[std::size_t(n)];
      ASSERT_EQ(slot < 0, graph.fixed[std::size_t(n)] == 7) << n;
      if (slot < 0) continue;
      EXPECT_TRUE(taken.insert(slot).second) << n;
      EXPECT_EQ(h.slots[std::size_t(slot)][0], n);
      EXPECT_LT(slot, h.first_supernode_slot());
    }
    EXPECT_EQ(h.levels(), &levels == &cases[0] ? 2U : 3U);
    EXPECT_EQ(h.first_block.back() - h.first_block[h.levels() - 1], 1) << "the last level has one block";
    for (std::size_t b = 0; b < h.blocks.size(); ++b) {
      const Index parent = h.blocks[b][0];
      EXPECT_EQ(parent < 0, b + 1 == h.blocks.size());
      for (std::size_t s = schwarz_slots * b; s < schwarz_slots * (b + 1); ++s) {
        const auto [source, above] = h.slots[s];
        EXPECT_EQ(above < 0, source < 0 || parent < 0);
        if (above >= 0) {
          EXPECT_EQ((h.first_supernode_slot() + above) / schwarz_slots, parent);
        }
        if (std::ptrdiff_t(s) >= h.first_supernode_slot() && source >= 0) {
          EXPECT_EQ(source, Index(s) - h.first_supernode_slot());
        }
      }
    }
    // Nodes of a supernode of the second level hang together by edges inside of it, and lie in one block.
    std::vector<Index> group(h.slots.size());
    std::iota(group.begin(), group.end(), Index{0});
    const std::function<Index(Index)> root = [&](Index s) {
      return group[std::size_t(s)] == s ? s : root(group[std::size_t(s)]);
    };
    for (const auto& [m, n] : graph.edges) {
      const Index a = h.node_slots[std::size_t(m)], b = h.node_slots[std::size_t(n)];
      if (a >= 0 && b >= 0 && a / schwarz_slots == b / schwarz_slots) group[std::size_t(root(a))] = root(b);
    }
    std::map<Index, Index> of_supernode;
    for (Index s = 0; s < h.first_supernode_slot(); ++s) {
      const auto [source, parent] = h.slots[std::size_t(s)];
      if (source < 0 || parent < 0) continue;
      const auto at = of_supernode.emplace(parent, root(s)).first;
      EXPECT_EQ(at->second, root(s));
      EXPECT_EQ(at->second / schwarz_slots, s / schwarz_slots);
    }
    std::set<Index> distinct;
    for (const auto& [supernode, component] : of_supernode) EXPECT_TRUE(distinct.insert(component).second);
  }
}

TEST(SchwarzHierarchy, pieces_apart_from_each_other_end_in_more_than_one_block) {
  Tets pieces;
  for (Index piece = 0; piece < 100; ++piece) {
    const double x = 2.0 * piece;
    for (const Point& corner : {Point{x, 0, 0}, Point{x + 1, 0, 0}, Point{x, 1, 0}, Point{x, 0, 1}}) {
      pieces.rest.push_back(corner);
    }
    pieces.tets.push_back({4 * piece, 4 * piece + 1, 4 * piece + 2, 4 * piece + 3});
  }
  const auto levels = make_levels(pieces, 0, false, [](const Point&) -> std::uint8_t { return 0; });
  const SchwarzHierarchy h = make_schwarz_hierarchy(make_level_graphs(levels).front(), levels[0].rest);
  ASSERT_EQ(h.levels(), 2U);
  EXPECT_GE(h.first_block[2] - h.first_block[1], 4);  // 100 supernodes
  for (Index b = h.first_block[1]; b < h.first_block[2]; ++b) EXPECT_EQ(h.blocks[std::size_t(b)][0], -1);
}

TEST(SchwarzHierarchy, of_a_body_without_free_nodes_is_empty) {
  auto levels = irregular();
  levels[0].fixed.assign(levels[0].fixed.size(), 7);
  const SchwarzHierarchy h = make_schwarz_hierarchy(make_level_graphs(levels).front(), levels[0].rest);
  EXPECT_EQ(h.block_count(), 0);
  EXPECT_TRUE(h.slots.empty());
}

}  // namespace
}  // namespace physgen::fem
