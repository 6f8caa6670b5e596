// Volume patches: a partition into small groups that hang together through faces.
#include <fem/mesh/at.h>
#include <fem/mesh/patches.h>
#include <gtest/gtest.h>
#include <physgen/error.h>
#include <physgen/threads.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "mesh_cases.h"

namespace physgen::fem {
namespace {

std::vector<Index> tets_of(const VolumePatches& patches, std::size_t p) {
  std::vector<Index> tets;
  for (Index k = patches.patch_tets.first[p]; k < patches.patch_tets.first[p + 1]; ++k) {
    tets.push_back(patches.patch_tets.entries[at(k)].element);
  }
  return tets;
}

std::set<Index> nodes_of(const TetMesh& mesh, const std::vector<Index>& tets) {
  std::set<Index> nodes;
  for (const Index t : tets) nodes.insert(mesh.tets[at(t)].begin(), mesh.tets[at(t)].end());
  return nodes;
}

bool share_a_face(const TetMesh& mesh, Index one, Index other) { return nodes_of(mesh, {one, other}).size() == 5; }

// Checks the properties of every VolumePatches.
void expect_partition(const TetMesh& mesh, const VolumePatches& patches) {
  const std::size_t count = patches.nodes.size();
  ASSERT_EQ(patches.node_counts.size(), count);
  ASSERT_EQ(patches.tet_patch.size(), mesh.tets.size());
  ASSERT_EQ(patches.tet_slots.size(), mesh.tets.size());
  ASSERT_EQ(patches.patch_tets.first.size(), count + 1);
  ASSERT_EQ(patches.patch_tets.entries.size(), mesh.tets.size());
  std::set<Index> seen;
  for (std::size_t p = 0; p < count; ++p) {
    const std::vector<Index> tets = tets_of(patches, p);
    ASSERT_FALSE(tets.empty());
    EXPECT_TRUE(std::ranges::is_sorted(tets));
    for (std::size_t k = 0; k < tets.size(); ++k) {
      EXPECT_EQ(at(patches.tet_patch[at(tets[k])]), p);
      EXPECT_EQ(at(patches.patch_tets.entries[at(patches.patch_tets.first[p]) + k].local), k);
      seen.insert(tets[k]);
    }
    const std::set<Index> nodes = nodes_of(mesh, tets);
    const auto& slots = patches.nodes[p];
    ASSERT_EQ(at(patches.node_counts[p]), nodes.size());
    ASSERT_LE(nodes.size(), 8u);
    EXPECT_TRUE(std::equal(nodes.begin(), nodes.end(), slots.begin()));
    for (std::size_t s = nodes.size(); s < 8; ++s) EXPECT_EQ(slots[s], slots[0]);
  }
  EXPECT_EQ(seen.size(), mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    for (std::size_t c = 0; c < 4; ++c) {
      ASSERT_LT(patches.tet_slots[t][c], patches.node_counts[at(patches.tet_patch[t])]);
      EXPECT_EQ(patches.nodes[at(patches.tet_patch[t])][patches.tet_slots[t][c]], mesh.tets[t][c]);
    }
  }
}

// The number of tets that can be reached from the first one through faces between tets of the patch.
std::size_t reached_through_faces(const TetMesh& mesh, const std::vector<Index>& tets) {
  std::vector<Index> reached{tets[0]};
  for (std::size_t next = 0; next < reached.size(); ++next) {
    for (const Index t : tets) {
      if (std::ranges::find(reached, t) == reached.end() && share_a_face(mesh, reached[next], t)) reached.push_back(t);
    }
  }
  return reached.size();
}

TEST(CellPatches, are_a_partition_with_the_corners_of_the_cells_in_order) {
  const TetMesh box = make_box_mesh(3, 2, 4);
  const VolumePatches patches = cell_patches(box);
  expect_partition(box, patches);
  ASSERT_EQ(patches.nodes.size(), 24u);
  for (Index z = 0, c = 0; z < 4; ++z) {
    for (Index y = 0; y < 2; ++y) {
      for (Index x = 0; x < 3; ++x, ++c) {
        EXPECT_EQ(patches.node_counts[at(c)], 8);
        for (Index s = 0; s < 8; ++s) {
          const Index node = x + (s & 1) + 4 * (y + (s >> 1 & 1) + 3 * (z + (s >> 2)));
          EXPECT_EQ(patches.nodes[at(c)][at(s)], node);
        }
        for (Index t = 6 * c; t < 6 * c + 6; ++t) EXPECT_EQ(patches.tet_patch[at(t)], c);
      }
    }
  }
}

TEST(CellPatches, take_boxes_of_every_small_size) {
  for (Index nx = 1; nx <= 3; ++nx) {
    for (Index ny = 1; ny <= 3; ++ny) {
      for (Index nz = 1; nz <= 3; ++nz) {
        const TetMesh box = make_box_mesh(nx, ny, nz);
        expect_partition(box, cell_patches(box));
      }
    }
  }
}

TEST(CellPatches, refuse_every_mesh_that_is_numbered_in_another_way) {
  const TetMesh box = make_box_mesh(3, 3, 3);
  EXPECT_THROW(cell_patches(make_tet_mesh(0, {})), Error);
  EXPECT_THROW(cell_patches(make_tet_mesh(4, {{0, 1, 2, 3}})), Error);
  EXPECT_THROW(cell_patches(renumbered(box, random_numbering(box, 5))), Error);
  const auto changed = [&box](const auto& change) {
    auto tets = box.tets;
    change(tets);
    return make_tet_mesh(box.nodes, std::move(tets));
  };
  const auto cell = [](auto& tets, std::ptrdiff_t c) { return tets.begin() + 6 * c; };
  EXPECT_NO_THROW(cell_patches(changed([](auto&) {})));
  EXPECT_THROW(cell_patches(changed([](auto& tets) { std::swap(tets[5], tets[6]); })), Error);
  EXPECT_THROW(
      cell_patches(changed([&](auto& tets) { std::swap_ranges(cell(tets, 0), cell(tets, 1), cell(tets, 7)); })), Error);
  EXPECT_THROW(cell_patches(changed([&](auto& tets) { tets.erase(cell(tets, 26), tets.end()); })), Error);
  EXPECT_THROW(cell_patches(make_tet_mesh(box.nodes + 1, box.tets)), Error);
}

TEST(GreedyPatches, are_a_partition_and_hang_together_through_faces) {
  for (const auto& [name, mesh, rest] : reference::mesh_cases()) {
    SCOPED_TRACE(name);
    const VolumePatches patches = greedy_patches(mesh);
    expect_partition(mesh, patches);
    for (std::size_t p = 0; p < patches.nodes.size(); ++p) {
      const std::vector<Index> tets = tets_of(patches, p);
      EXPECT_EQ(reached_through_faces(mesh, tets), tets.size()) << "patch " << p;
    }
  }
}

TEST(GreedyPatches, leave_one_or_two_tets_only_where_no_neighbour_has_room) {
  for (const auto& [name, mesh, rest] : reference::mesh_cases()) {
    SCOPED_TRACE(name);
    const VolumePatches patches = greedy_patches(mesh);
    for (std::size_t p = 0; p < patches.nodes.size(); ++p) {
      const std::vector<Index> tets = tets_of(patches, p);
      if (tets.size() > 2) continue;
      for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        if (at(patches.tet_patch[t]) == p) continue;
        const auto touches = [&](Index own) { return share_a_face(mesh, own, static_cast<Index>(t)); };
        if (std::ranges::none_of(tets, touches)) continue;
        std::set<Index> together = nodes_of(mesh, tets);
        together.merge(nodes_of(mesh, tets_of(patches, at(patches.tet_patch[t]))));
        EXPECT_GT(together.size(), 8u) << "patch " << p << " of " << tets.size() << " tets beside tet " << t;
      }
    }
  }
}

// One constraint per node does not lock; a patch of one tet is a constraint of its own. Over 300 seeds there were 0.85
// to 0.87 patches per node, at most 1.1 % of them of one or two tets.
TEST(GreedyPatches, are_about_one_per_node_and_hardly_ever_small_whatever_the_numbering) {
  const auto box = reference::box(12, 12, 12);
  for (const auto& [name, mesh, rest] : {box, reference::shuffled(box, 9)}) {
    const VolumePatches patches = greedy_patches(mesh);
    const auto count = static_cast<double>(patches.nodes.size());
    EXPECT_GT(count / mesh.nodes, 0.8) << name;
    EXPECT_LT(count / mesh.nodes, 0.92) << name;
    double small = 0;
    for (std::size_t p = 0; p < patches.nodes.size(); ++p) small += tets_of(patches, p).size() <= 2 ? 1 : 0;
    EXPECT_LT(small / count, 0.02) << name;
  }
}

TEST(GreedyPatches, depend_on_the_mesh_alone) {
  const TetMesh mesh = reference::shuffled(reference::box(20, 20, 20), 11).mesh;
  set_threads(1);
  const VolumePatches alone = greedy_patches(mesh);
  for (const int threads : {2, 16}) {
    set_threads(threads);
    const VolumePatches patches = greedy_patches(mesh);
    EXPECT_EQ(patches.tet_patch, alone.tet_patch) << threads << " threads";
    EXPECT_EQ(patches.tet_slots, alone.tet_slots) << threads << " threads";
  }
  set_threads(0);
}

TEST(GreedyPatches, take_a_node_with_thousands_of_tets) {
  const TetMesh mesh = reference::shuffled(reference::star(5000), 12).mesh;
  const VolumePatches patches = greedy_patches(mesh);
  expect_partition(mesh, patches);
  EXPECT_LT(patches.nodes.size(), 1250u);
}

TEST(GreedyPatches, take_the_mesh_of_a_few_tets_whole) {
  EXPECT_TRUE(greedy_patches(make_tet_mesh(3, {})).nodes.empty());
  EXPECT_EQ(greedy_patches(make_tet_mesh(5, {{1, 2, 3, 4}})).nodes,
            (std::vector<std::array<Index, 8>>{{1, 2, 3, 4, 1, 1, 1, 1}}));
  EXPECT_EQ(greedy_patches(make_tet_mesh(6, {{0, 1, 2, 3}, {5, 1, 2, 3}})).nodes,
            (std::vector<std::array<Index, 8>>{{0, 1, 2, 3, 5, 0, 0, 0}}));
  EXPECT_EQ(greedy_patches(make_box_mesh(1, 1, 1)).nodes,
            (std::vector<std::array<Index, 8>>{{0, 1, 2, 3, 4, 5, 6, 7}}));
}

TEST(GreedyPatches, stop_at_six_tets_and_at_eight_nodes) {
  // Ten tets of eight nodes: six around edge 0-1, and four that fill one end.
  const TetMesh ten = make_tet_mesh(8, {{0, 1, 2, 3},
                                        {0, 1, 3, 4},
                                        {0, 1, 4, 5},
                                        {0, 1, 5, 6},
                                        {0, 1, 6, 7},
                                        {0, 1, 7, 2},
                                        {0, 2, 3, 4},
                                        {0, 4, 5, 6},
                                        {0, 6, 7, 2},
                                        {0, 2, 4, 6}});
  EXPECT_EQ(greedy_patches(ten).patch_tets.first, (std::vector<Index>{0, 6, 10}));
  // A chain of tets that each need a new node: five of them have eight nodes; the sixth starts anew and finds no room.
  std::vector<std::array<Index, 4>> chain;
  chain.reserve(6);
  for (Index i = 0; i < 6; ++i) chain.push_back({i, i + 1, i + 2, i + 3});
  EXPECT_EQ(greedy_patches(make_tet_mesh(9, chain)).tet_patch, (std::vector<Index>{0, 0, 0, 0, 0, 1}));
}

// Tet 0 takes tet 1, since tet 2 has more free neighbours. Then tet 2 adds no node, tet 3 one, which has fewer free
// neighbours. Only with tet 2 first do tets 4 and 5 get their places before tet 6, which needs a ninth node.
TEST(GreedyPatches, take_the_neighbour_that_shares_most_corners) {
  const TetMesh mesh = make_tet_mesh(
      9, {{0, 1, 2, 3}, {0, 1, 3, 4}, {0, 1, 4, 2}, {0, 3, 4, 5}, {0, 2, 4, 6}, {1, 2, 4, 7}, {3, 4, 5, 8}});
  EXPECT_EQ(greedy_patches(mesh).tet_patch, (std::vector<Index>{0, 0, 0, 0, 0, 0, 1}));
}

TEST(GreedyPatches, refuse_a_face_of_three_tets) {
  try {
    static_cast<void>(greedy_patches(make_tet_mesh(6, {{0, 1, 2, 3}, {1, 2, 0, 4}, {2, 0, 1, 5}})));
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "physgen: patches: 3 tets have the face of nodes 0, 1, 2, among them tets 0 and 1; at most two tets "
                 "may share a face");
  }
}

}  // namespace
}  // namespace physgen::fem
