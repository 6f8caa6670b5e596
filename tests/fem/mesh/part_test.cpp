// Parts of meshes on several ranks, against a search through all tets.
#include <fem/mesh/at.h>
#include <fem/mesh/part.h>
#include <gtest/gtest.h>
#include <physgen/error.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>

#include "mesh_cases.h"

namespace physgen::fem {
namespace {

using Tets = std::vector<std::array<Index, 4>>;

void expect_same(const MeshPart& one, const MeshPart& other) {
  EXPECT_EQ(one.tet_numbers, other.tet_numbers);
  EXPECT_EQ(one.tet_corners, other.tet_corners);
  EXPECT_TRUE(std::ranges::equal(one.nodes.ghosts(), other.nodes.ghosts()));
  EXPECT_EQ(one.nodes.begin(), other.nodes.begin());
}

/// A part holds what a search finds, and nothing else.
void expect_part_of(const MeshPart& part, const Tets& tets, const Runs& runs, int rank) {
  std::vector<Index> numbers;
  std::set<index_t> ghosts;
  for (std::size_t t = 0; t < tets.size(); ++t) {
    bool touches = false;
    for (const Index n : tets[t]) touches = touches || runs.owner(n) == rank;
    if (!touches) continue;
    numbers.push_back(static_cast<Index>(t));
    for (const Index n : tets[t]) {
      if (runs.owner(n) != rank) ghosts.insert(n);
    }
  }
  ASSERT_EQ(part.tet_numbers, numbers);
  ASSERT_TRUE(std::ranges::equal(part.nodes.ghosts(), ghosts));
  const Tets local = part.local_tets();
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    ASSERT_EQ(part.tet_corners[k], tets[at(numbers[k])]);
    for (std::size_t c = 0; c < 4; ++c) ASSERT_EQ(part.nodes.global(local[k][c]), part.tet_corners[k][c]);
  }
}

/// Every node is owned once, and every tet is somewhere.
void expect_parts_of(const Tets& tets, const Runs& runs) {
  std::vector<int> owners(at(runs.size()), 0), holders(tets.size(), 0);
  for (int rank = 0; rank < runs.ranks(); ++rank) {
    const MeshPart part = part_of(tets, runs, rank);
    expect_part_of(part, tets, runs, rank);
    for (index_t n = runs.begin(rank); n < runs.end(rank); ++n) ++owners[at(n)];
    for (const Index t : part.tet_numbers) ++holders[at(t)];
  }
  EXPECT_TRUE(std::ranges::all_of(owners, [](int count) { return count == 1; }));
  EXPECT_TRUE(std::ranges::all_of(holders, [](int count) { return count >= 1; }));
}

std::string refusal(const auto& make) {
  try {
    static_cast<void>(make());
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(MeshParts, of_random_meshes_have_the_tets_that_touch_owned_nodes_and_their_nodes) {
  for (const auto& [name, mesh, rest] :
       {reference::shuffled(reference::cut_at_random(reference::box(17, 18, 19), 900, 1), 2),
        reference::shuffled(reference::beside(reference::box(9, 9, 40), reference::box(14, 14, 14)), 3)}) {
    SCOPED_TRACE(name);
    for (const int ranks : {1, 2, 3, 5, 8}) expect_parts_of(mesh.tets, Runs::of_blocks(mesh.nodes, ranks));
  }
  for (const auto& [name, mesh, rest] : reference::mesh_cases()) {  // of one block: all ranks but one have nothing
    SCOPED_TRACE(name);
    for (const int ranks : {1, 3}) expect_parts_of(mesh.tets, Runs::of_blocks(mesh.nodes, ranks));
  }
}

TEST(MeshParts, of_boxes_by_formula_are_those_of_the_whole_mesh) {
  struct Box {
    Index nx, ny, nz;
    MirroredFrom mirrored;
  };
  for (const Box& box : {Box{16, 16, 16, {}}, Box{20, 20, 20, {10, 10, 10}}, Box{3, 5, 300, {1, 2, 150}},
                         Box{90, 60, 1, {}}, Box{1, 1, 2000, {}}, Box{5, 4, 3, {}}}) {
    const TetMesh mesh = make_box_mesh(box.nx, box.ny, box.nz, box.mirrored);
    SCOPED_TRACE(std::to_string(box.nx) + " x " + std::to_string(box.ny) + " x " + std::to_string(box.nz));
    for (int ranks = 1; ranks <= 8; ++ranks) {
      const Runs runs = Runs::of_blocks(mesh.nodes, ranks);
      for (int rank = 0; rank < ranks; ++rank) {
        SCOPED_TRACE("rank " + std::to_string(rank) + " of " + std::to_string(ranks));
        expect_same(part_of_box(box.nx, box.ny, box.nz, box.mirrored, runs, rank), part_of(mesh.tets, runs, rank));
      }
    }
  }
}

TEST(MeshParts, of_a_cube_of_48_cells_have_two_planes_of_ghosts_per_cut_and_their_share_of_the_bytes) {
  constexpr Index n = 48;
  constexpr index_t plane = (n + 1) * (n + 1), nodes = plane * (n + 1);
  const MirroredFrom mirrored{n / 2, n / 2, n / 2};
  const std::int64_t whole = part_of_box(n, n, n, mirrored, Runs::of_blocks(nodes, 1), 0).bytes();
  EXPECT_EQ(whole, 6 * n * n * n * 5 * 4);
  for (const int ranks : {2, 4, 8}) {
    const Runs runs = Runs::of_blocks(nodes, ranks);
    for (int rank = 0; rank < ranks; ++rank) {
      const MeshPart part = part_of_box(n, n, n, mirrored, runs, rank);
      const index_t cuts = (rank > 0 ? 1 : 0) + (rank + 1 < ranks ? 1 : 0);
      EXPECT_LE(static_cast<index_t>(part.nodes.ghosts().size()), 2 * plane * cuts);
      EXPECT_GE(static_cast<index_t>(part.nodes.ghosts().size()), plane * cuts);
      // A rank's owned nodes are as many blocks as another's, or one more; beyond its share it has two layers of tets
      // per cut.
      const auto share = static_cast<double>(whole) * static_cast<double>(runs.end(rank) - runs.begin(rank)) / nodes;
      const auto halo = static_cast<double>(cuts * (6 * n * n * 5 * 4 + plane * 8));
      EXPECT_LE(static_cast<double>(part.bytes()), 1.1 * share + halo) << rank << " of " << ranks;
    }
  }
}

TEST(MeshParts, give_edges_in_the_order_of_the_whole_mesh) {
  const TetMesh mesh = make_box_mesh(14, 15, 16);
  const Runs runs = Runs::of_blocks(mesh.nodes, 2);
  for (int rank = 0; rank < 2; ++rank) {
    const MeshPart part = part_of(mesh.tets, runs, rank);
    const TetMesh local = make_tet_mesh(static_cast<Index>(part.nodes.size()), part.local_tets());
    std::vector<std::array<Index, 2>> edges;  // of owned nodes, in global numbers
    for (const auto& [m, n] : local.edges) {
      const std::array ends{static_cast<Index>(part.nodes.global(m)), static_cast<Index>(part.nodes.global(n))};
      if (runs.owns(rank, ends[0]) || runs.owns(rank, ends[1])) edges.push_back(ends);
    }
    std::vector<std::array<Index, 2>> expected;
    std::ranges::copy_if(mesh.edges, std::back_inserter(expected),
                         [&](const auto& edge) { return runs.owns(rank, edge[0]) || runs.owns(rank, edge[1]); });
    EXPECT_EQ(edges, expected);
  }
}

TEST(MeshParts, of_what_does_not_fit_are_refused_with_value_and_remedy) {
  const TetMesh mesh = make_box_mesh(2, 2, 2);
  const Runs runs = Runs::of_blocks(27, 2), other = Runs::of_blocks(26, 2);
  EXPECT_EQ(refusal([&] { return part_of(mesh.tets, runs, 2); }),
            "physgen: part of a mesh: there is no rank 2 of 2; name one of 0 .. 1");
  EXPECT_EQ(refusal([&] { return part_of_box(2, 2, 2, {}, runs, -1); }),
            "physgen: part of a mesh: there is no rank -1 of 2; name one of 0 .. 1");
  EXPECT_EQ(refusal([&] { return part_of(mesh.tets, other, 0); }),
            "physgen: part of a mesh: tet 42 names node 26, which is none of 26; give the runs of this mesh's nodes");
  EXPECT_EQ(refusal([&] { return part_of_box(2, 2, 2, {}, other, 0); }),
            "physgen: part of a box: cells 2 x 2 x 2 have 27 nodes, and the runs are of 26; give the runs of this "
            "box's nodes");
  EXPECT_EQ(refusal([&] { return part_of_box(2, 0, 2, {}, runs, 0); }),
            "physgen: part of a box: cells 2 x 0 x 2; each count must be at least 1");
}

}  // namespace
}  // namespace physgen::fem
