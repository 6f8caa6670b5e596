// The lists of meshes, made in parallel, against sets and maps that are filled one entry after the other; on 1, 2 and
// 16 threads.
#include <fem/mesh/at.h>
#include <fem/mesh/boundary.h>
#include <fem/mesh/patches.h>
#include <fem/mesh/refine.h>
#include <fem/mesh/rings.h>
#include <gtest/gtest.h>
#include <physgen/error.h>
#include <physgen/threads.h>

#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "mesh_cases.h"

namespace physgen::fem {
namespace {

using Tet = std::array<Index, 4>;
using Edge = std::array<Index, 2>;

/// The entries of each object, ascending.
IncidenceList listed(const std::vector<std::set<IncidenceEntry>>& sets) {
  IncidenceList list{{0}, {}};
  for (const auto& set : sets) {
    list.entries.insert(list.entries.end(), set.begin(), set.end());
    list.first.push_back(static_cast<Index>(list.entries.size()));
  }
  return list;
}

TetMesh expected_mesh(Index nodes, const std::vector<Tet>& tets) {
  TetMesh mesh;
  mesh.nodes = nodes;
  std::vector<std::set<IncidenceEntry>> node_tets(at(nodes)), node_edges(at(nodes)), edge_tets;
  std::map<Edge, std::set<IncidenceEntry>> edges;
  for (Index t = 0; t < static_cast<Index>(tets.size()); ++t) {
    for (Index c = 0; c < 4; ++c) node_tets[at(tets[at(t)][at(c)])].insert({t, c});
    for (Index local = 0; local < 6; ++local) {
      const auto [i, j] = tet_edges[at(local)];
      const Index a = tets[at(t)][at(i)], b = tets[at(t)][at(j)];
      edges[{std::min(a, b), std::max(a, b)}].insert({t, a < b ? local : local + 6});
    }
  }
  for (const auto& [edge, entries] : edges) {
    for (Index side = 0; side < 2; ++side) {
      node_edges[at(edge[at(side)])].insert({static_cast<Index>(mesh.edges.size()), side});
    }
    mesh.edges.push_back(edge);
    edge_tets.push_back(entries);
  }
  mesh.node_tets = listed(node_tets);
  mesh.node_edges = listed(node_edges);
  mesh.edge_tets = listed(edge_tets);
  return mesh;
}

/// Faces that one tet has, with its number and corner opposite, by their nodes in ascending order.
std::vector<std::array<Index, 3>> expected_boundary(const std::vector<Tet>& tets) {
  std::map<std::array<Index, 3>, int> faces;
  for (const Tet& tet : tets) {
    for (std::size_t c = 0; c < 4; ++c) {
      std::array<Index, 3> face{tet[(c + 1) % 4], tet[(c + 2) % 4], tet[(c + 3) % 4]};
      std::ranges::sort(face);
      ++faces[face];
    }
  }
  std::vector<std::array<Index, 3>> boundary;
  for (const auto& [face, count] : faces) {
    if (count == 1) boundary.push_back(face);
  }
  return boundary;
}

void expect_equal_lists(const TetMesh& mesh, const TetMesh& expected) {
  EXPECT_EQ(mesh.nodes, expected.nodes);
  EXPECT_EQ(mesh.edges, expected.edges);
  EXPECT_EQ(mesh.node_tets, expected.node_tets);
  EXPECT_EQ(mesh.node_edges, expected.node_edges);
  EXPECT_EQ(mesh.edge_tets, expected.edge_tets);
}

void expect_right_lists(Index nodes, const std::vector<Tet>& tets) {
  const TetMesh expected = expected_mesh(nodes, tets);
  std::vector<std::set<Index>> rings(at(nodes));
  for (Index n = 0; n < nodes; ++n) rings[at(n)].insert(n);
  for (const auto& [m, n] : expected.edges) {
    rings[at(m)].insert(n);
    rings[at(n)].insert(m);
  }
  std::set<Edge> pairs;
  for (Index m = 0; nodes < 2000 && m < nodes; ++m) {
    for (const Index middle : rings[at(m)]) {
      for (const Index n : rings[at(middle)]) {
        if (m < n) pairs.insert({m, n});
      }
    }
  }
  for (const int count : {1, 2, 16}) {
    SCOPED_TRACE(std::to_string(count) + " threads");
    set_threads(count);
    const TetMesh mesh = make_tet_mesh(nodes, tets);
    expect_equal_lists(mesh, expected);
    const NodeRings found = make_rings(mesh);
    ASSERT_EQ(found.first.size(), rings.size() + 1);
    for (std::size_t n = 0; n < rings.size(); ++n) {
      EXPECT_EQ(std::vector<Index>(found.nodes.begin() + found.first[n], found.nodes.begin() + found.first[n + 1]),
                std::vector<Index>(rings[n].begin(), rings[n].end()));
    }
    if (nodes < 2000) {
      EXPECT_EQ(pairs_in_rings(found), std::vector<Edge>(pairs.begin(), pairs.end()));
    }
    std::vector<std::array<Index, 3>> boundary;
    for (auto face : boundary_faces(mesh)) {
      EXPECT_EQ(face[0], std::ranges::min(face));
      std::ranges::sort(face);
      boundary.push_back(face);
    }
    EXPECT_EQ(boundary, expected_boundary(tets));
  }
  set_threads(0);
}

TEST(MeshLists, of_boxes_by_formula_are_those_of_their_tets_in_each_mirrored_form) {
  constexpr Index none = MirroredFrom::none;
  for (const Index from_x : {none, 0, 1, 2, 4}) {
    for (const Index from_y : {none, 0, 1, 3}) {
      for (const Index from_z : {none, 0, 1, 5}) {
        for (const auto& [x, y, z] : {std::array<Index, 3>{1, 1, 1}, {2, 2, 2}, {3, 4, 2}, {1, 5, 6}, {7, 1, 1}}) {
          for (const int count : {1, 2, 16}) {
            set_threads(count);
            const TetMesh box = make_box_mesh(x, y, z, {from_x, from_y, from_z}),
                          same = make_tet_mesh(box.nodes, box.tets);
            expect_equal_lists(box, same);
            EXPECT_EQ(boundary_faces(box), boundary_faces(same));
          }
        }
      }
    }
  }
  for (const auto& [x, y, z] : {std::array<Index, 3>{3, 4, 2}, {9, 8, 11}}) {
    const TetMesh box = make_box_mesh(x, y, z, {1, 4, 0});
    expect_right_lists(box.nodes, box.tets);
  }
}

TEST(MeshLists, a_mesh_that_only_looks_like_a_box_has_the_surface_of_its_tets) {
  const TetMesh box = make_box_mesh(7, 5, 6, {3, 2, 4});
  const auto last = static_cast<std::ptrdiff_t>(box.tets.size()) - 1;
  for (const std::ptrdiff_t tet : {std::ptrdiff_t{0}, last / 2, last}) {
    std::vector<Tet> tets = box.tets;
    const auto expect_own_surface = [&](const BoxCells& cells) {
      const TetMesh plain = make_tet_mesh(box.nodes, tets);
      TetMesh labelled = plain;
      labelled.box = cells;
      EXPECT_EQ(boundary_faces(labelled), boundary_faces(plain));
    };
    std::swap(tets[at(tet)][1], tets[at(tet)][2]);  // seen from outside the other way round
    expect_own_surface(*box.box);
    tets = box.tets;
    tets.erase(tets.begin() + tet);
    expect_own_surface(*box.box);
    tets.insert(tets.begin(), box.tets[at(tet)]);  // as many, in another order
    expect_own_surface(*box.box);
    tets = box.tets;
    expect_own_surface({{5, 7, 6}, {3, 2, 4}});
    expect_own_surface({{7, 5, 6}, {3, 2, 3}});
  }
}

TEST(MeshLists, a_box_with_counts_below_1_or_beyond_numbers_is_none) {
  const auto expect_surface_of_its_tets = [](TetMesh mesh, const BoxCells& cells) {
    mesh.box = cells;
    EXPECT_EQ(boundary_faces(mesh), (std::vector<Face>{{4, 6, 5}, {4, 5, 7}, {4, 7, 6}, {5, 6, 7}}));
  };
  // As many nodes and tets as these counts give; loops over their cells visit none.
  for (const BoxCells& cells : {BoxCells{{-3, -2, 4}, {}}, {{-2, 3, -3}, {1, 1, 1}}, {{3, -2, -3}, {}}}) {
    const auto& [x, y, z] = cells.cells;
    std::vector<Tet> tets(at(6 * x * y * z), {0, 1, 2, 3});
    tets.back() = {4, 5, 6, 7};
    expect_surface_of_its_tets(make_tet_mesh((x + 1) * (y + 1) * (z + 1), tets), cells);
  }
  const TetMesh mesh = make_tet_mesh(8, {{0, 1, 2, 3}, {0, 1, 2, 3}, {0, 1, 2, 3}, {4, 5, 6, 7}});
  constexpr Index most = std::numeric_limits<Index>::max();
  for (const BoxCells& cells : {BoxCells{{0, 0, 7}, {}}, {{1, 1, most}, {}}, {{most, most, most}, {}}}) {
    expect_surface_of_its_tets(mesh, cells);
  }
}

TEST(MeshLists, of_irregular_and_refined_meshes_are_those_of_sets) {
  const reference::MeshCase given = reference::shuffled(reference::box(5, 7, 6), 11);
  expect_right_lists(given.mesh.nodes, given.mesh.tets);
  for (const int count : {1, 2, 16}) {
    set_threads(count);
    const Refined fine = refine(given.mesh, given.rest);
    expect_right_lists(fine.mesh.nodes, fine.mesh.tets);
  }
}

TEST(MeshLists, of_tets_of_any_nodes_are_those_of_sets) {
  auto random = reference::random_stream(13);
  for (const Index nodes : {4, 6, 50, 1000}) {
    std::vector<Tet> tets(3000);
    for (Tet& tet : tets) {
      std::set<Index> corners;
      while (corners.size() < 4) corners.insert(static_cast<Index>(random() % static_cast<unsigned>(nodes)));
      std::ranges::copy(corners, tet.begin());
      std::ranges::shuffle(tet, random);
    }
    expect_right_lists(nodes, tets);
  }
}

TEST(MeshLists, of_a_node_with_5000_tets_are_those_of_sets) {
  std::vector<Tet> star;  // all tets in one node's star, around its axis from node 0 to node 1
  constexpr Index count = 5000;
  for (Index k = 0; k < count; ++k) star.push_back({0, 1, 2 + k, 2 + (k + 1) % count});
  expect_right_lists(count + 2, star);
  std::vector<Tet> loose;  // the highest node has them, and nothing else is shared
  for (Index k = 0; k < count; ++k) loose.push_back({3 * k, 3 * k + 1, 3 * k + 2, 3 * count});
  expect_right_lists(3 * count + 1, loose);
}

TEST(MeshLists, of_one_tet_of_two_bodies_and_of_nodes_without_tets_are_those_of_sets) {
  expect_right_lists(0, {});
  expect_right_lists(9, {});
  expect_right_lists(4, {{2, 1, 0, 3}});
  expect_right_lists(20, {{7, 3, 12, 9}});
  expect_right_lists(12, {{0, 1, 2, 3}, {8, 9, 10, 11}});
}

TEST(MeshLists, the_lowest_tet_that_is_wrong_is_named_on_any_number_of_threads) {
  std::vector<Tet> tets(100000, {0, 1, 2, 3});
  tets[70001] = {0, 1, 1, 3};
  tets[99999] = {0, 1, 2, 4};
  for (const int count : {1, 2, 16}) {
    set_threads(count);
    try {
      (void)make_tet_mesh(4, tets);
      FAIL();
    } catch (const Error& error) {
      EXPECT_STREQ(error.what(), "physgen: mesh: tet 70001 names a node twice");
    }
  }
  set_threads(0);
}

TEST(MeshLists, patches_of_cells_are_the_cells_of_boxes_and_nothing_else) {
  for (const int count : {1, 2, 16}) {
    set_threads(count);
    for (const auto& [x, y, z] : {std::array<Index, 3>{1, 1, 1}, {3, 4, 2}, {5, 1, 7}, {8, 9, 10}}) {
      TetMesh box = make_box_mesh(x, y, z, {1, 2, 1});
      const VolumePatches patches = cell_patches(box);
      ASSERT_EQ(std::ssize(patches.nodes), x * y * z);
      for (std::size_t p = 0; p < patches.nodes.size(); ++p) {
        std::set<Index> corners;
        for (std::size_t t = 6 * p; t < 6 * p + 6; ++t) {
          corners.insert(box.tets[t].begin(), box.tets[t].end());
          EXPECT_EQ(patches.tet_patch[t], static_cast<Index>(p));
          EXPECT_EQ(patches.patch_tets.entries[t],
                    (IncidenceEntry{static_cast<Index>(t), static_cast<Index>(t - 6 * p)}));
          for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(patches.nodes[p][patches.tet_slots[t][c]], box.tets[t][c]);
        }
        EXPECT_EQ(std::vector<Index>(patches.nodes[p].begin(), patches.nodes[p].end()),
                  std::vector<Index>(corners.begin(), corners.end()));
        EXPECT_EQ(patches.node_counts[p], 8);
        EXPECT_EQ(patches.patch_tets.first[p + 1], 6 * static_cast<Index>(p + 1));
      }
      if (x * y * z == 1) continue;
      std::swap(box.tets[5], box.tets[6]);
      EXPECT_THROW((void)cell_patches(box), Error);
    }
  }
  set_threads(0);
}

}  // namespace
}  // namespace physgen::fem
