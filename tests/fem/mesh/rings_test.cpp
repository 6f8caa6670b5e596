// Rings of nodes and the pairs in them, against what they are by definition.
#include <fem/mesh/rings.h>
#include <gtest/gtest.h>

#include <set>

#include "mesh_cases.h"

namespace physgen::fem {
namespace {

using Pair = std::array<Index, 2>;

std::vector<std::set<Index>> sets_of(const TetMesh& mesh) {
  std::vector<std::set<Index>> sets(static_cast<std::size_t>(mesh.nodes));
  for (Index n = 0; n < mesh.nodes; ++n) sets[static_cast<std::size_t>(n)].insert(n);
  for (const auto& tet : mesh.tets) {
    for (const Index a : tet) sets[static_cast<std::size_t>(a)].insert(tet.begin(), tet.end());
  }
  return sets;
}

void expect_rings(const TetMesh& mesh) {
  const NodeRings rings = make_rings(mesh);
  const auto sets = sets_of(mesh);
  ASSERT_EQ(rings.first.size(), sets.size() + 1);
  std::set<Pair> pairs;
  for (std::size_t n = 0; n < sets.size(); ++n) {
    const std::vector<Index> ring(rings.nodes.begin() + rings.first[n], rings.nodes.begin() + rings.first[n + 1]);
    EXPECT_EQ(ring, std::vector<Index>(sets[n].begin(), sets[n].end())) << n;
    for (const Index a : sets[n]) {
      for (const Index b : sets[n]) {
        if (a < b) pairs.insert({a, b});
      }
    }
  }
  EXPECT_EQ(pairs_in_rings(rings), std::vector<Pair>(pairs.begin(), pairs.end()));
}

TEST(Rings, are_a_node_and_its_neighbours) {
  expect_rings(make_tet_mesh(4, {{0, 1, 2, 3}}));
  expect_rings(make_tet_mesh(9, {{4, 2, 0, 7}, {7, 8, 4, 1}, {5, 6, 3, 8}}));
  expect_rings(make_tet_mesh(3, {}));
  expect_rings(make_box_mesh(3, 2, 4));
  for (const reference::MeshCase& given : reference::mesh_cases()) {
    SCOPED_TRACE(given.name);
    expect_rings(given.mesh);
  }
}

TEST(Rings, inside_of_a_box_have_15_nodes_and_32_pairs_each) {
  const auto count = [](Index n) {
    const NodeRings rings = make_rings(make_box_mesh(n, n, n));
    return std::array{rings.nodes.size(), pairs_in_rings(rings).size()};
  };
  // Differences of third order leave what grows with the volume alone: 6 times that of a cell.
  const auto a = count(3), b = count(4), c = count(5), d = count(6);
  EXPECT_EQ(d[0] - 3 * c[0] + 3 * b[0] - a[0], 6 * 15);
  EXPECT_EQ(d[1] - 3 * c[1] + 3 * b[1] - a[1], 6 * 32);
}

}  // namespace
}  // namespace physgen::fem
