// Orders by parts that METIS finds, and what follows the new numbers of a mesh: finer meshes, patches and groups.
#include <fem/mesh/at.h>
#include <fem/mesh/follow_numbers.h>
#include <fem/mesh/order.h>
#include <fem/mesh/refine.h>
#include <gtest/gtest.h>
#include <physgen/error.h>
#include <physgen/threads.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <set>
#include <string>
#include <thread>

#include "mesh_cases.h"

namespace physgen::fem {
namespace {

using reference::MeshCase;

void expect_permutation(std::vector<Index> order, std::size_t count) {
  std::vector<Index> expected(count);
  std::iota(expected.begin(), expected.end(), 0);
  std::ranges::sort(order);
  EXPECT_EQ(order, expected);
}

/// A body whose numbers jump, and one with two bodies beside each other.
std::vector<MeshCase> random_meshes() {
  return {reference::shuffled(reference::jittered(reference::box(15, 16, 17), 0.1, 11), 12),
          reference::shuffled(reference::beside(reference::box(8, 8, 8), reference::box(4, 20, 9)), 13)};
}

/// Edges of the mesh whose ends lie in other runs, of `runs` runs of as many nodes.
std::size_t cut_edges(const TetMesh& mesh, Index runs) {
  const auto run = [&](Index n) { return static_cast<std::int64_t>(n) * runs / mesh.nodes; };
  return static_cast<std::size_t>(
      std::ranges::count_if(mesh.edges, [&](const auto& edge) { return run(edge[0]) != run(edge[1]); }));
}

class OrdersByParts : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_metis()) GTEST_SKIP() << "this build has no METIS (libmetis-dev)";
  }
};

TEST_F(OrdersByParts, are_permutations_of_nodes_and_tets) {
  std::vector<MeshCase> cases = reference::mesh_cases();
  std::ranges::move(random_meshes(), std::back_inserter(cases));
  cases.push_back({"a node without tets", make_tet_mesh(5, {{0, 1, 2, 4}}), {}});
  cases.push_back({"no tets", make_tet_mesh(0, {}), {}});
  cases.push_back({"600 loose nodes", make_tet_mesh(600, {}), {}});
  for (const MeshCase& c : cases) {
    SCOPED_TRACE(c.name);
    const Renumbering numbers = order_by_parts(c.mesh);
    expect_permutation(numbers.node_order, at(c.mesh.nodes));
    expect_permutation(numbers.tet_order, c.mesh.tets.size());
    const TetMesh ordered = renumbered(c.mesh, numbers);
    EXPECT_EQ(ordered.edges.size(), c.mesh.edges.size());
  }
}

TEST_F(OrdersByParts, keep_the_order_of_the_file_within_64_parts) {
  for (const MeshCase& c : random_meshes()) {
    SCOPED_TRACE(c.name);
    const Renumbering numbers = order_by_parts(c.mesh);
    // Old numbers ascend but where a part begins.
    const auto descents = [](const std::vector<Index>& order) {
      std::size_t count = 0;
      for (std::size_t i = 1; i < order.size(); ++i) count += order[i] < order[i - 1] ? 1U : 0U;
      return count;
    };
    EXPECT_GT(descents(numbers.node_order), 31U);
    EXPECT_LE(descents(numbers.node_order), 63U);
    EXPECT_LE(descents(numbers.tet_order), 63U);
  }
}

TEST_F(OrdersByParts, give_runs_that_are_compact_bodies) {
  for (const MeshCase& c : random_meshes()) {
    SCOPED_TRACE(c.name);
    const TetMesh ordered = renumbered(c.mesh, order_by_parts(c.mesh));
    for (const Index runs : {2, 4, 8}) {
      // At random, 1 - 1/runs of all edges are cut; runs of compact bodies have a surface each.
      EXPECT_GT(cut_edges(c.mesh, runs), ordered.edges.size() / 3);
      EXPECT_LT(cut_edges(ordered, runs), ordered.edges.size() * at(runs) / 25) << runs << " runs";
    }
  }
  // Slabs of the box, which its own numbers give, have more than twice the surface of eight compact bodies.
  const MeshCase box = random_meshes()[0];
  EXPECT_LT(3 * cut_edges(renumbered(box.mesh, order_by_parts(box.mesh)), 8),
            2 * cut_edges(make_box_mesh(15, 16, 17), 8));
}

TEST_F(OrdersByParts, are_the_same_again_on_other_threads_and_beside_each_other) {
  const std::vector<MeshCase> cases = random_meshes();
  const Renumbering one = order_by_parts(cases[0].mesh), other = order_by_parts(cases[1].mesh);
  for (const int threads : {1, 2}) {
    set_threads(threads);
    EXPECT_EQ(order_by_parts(cases[0].mesh), one) << threads << " threads";
  }
  set_threads(0);
  std::array<std::vector<Renumbering>, 2> found;
  {
    std::vector<std::jthread> beside;
    for (std::size_t k = 0; k < 2; ++k) {
      beside.emplace_back([&, k] {
        for (int again = 0; again < 3; ++again) found.at(k).push_back(order_by_parts(cases[k].mesh));
      });
    }
  }
  EXPECT_EQ(found[0], std::vector(3, one));
  EXPECT_EQ(found[1], std::vector(3, other));
}

TEST_F(OrdersByParts, keep_tets_in_the_order_of_their_materials) {
  const MeshCase c = reference::shuffled(reference::box(9, 9, 9), 14);
  const auto count = static_cast<Index>(c.mesh.tets.size());
  const std::vector<Index> ends{count / 3, count / 2, count};
  const Renumbering numbers = order_by_parts(c.mesh, ends);
  expect_permutation(numbers.tet_order, c.mesh.tets.size());
  for (std::size_t t = 0; t < numbers.tet_order.size(); ++t) {
    const auto material = [&](Index tet) { return std::ranges::upper_bound(ends, tet) - ends.begin(); };
    ASSERT_EQ(material(numbers.tet_order[t]), material(static_cast<Index>(t)));
  }
}

TEST(OrdersWithoutMetis, are_refused_with_its_package) {
  if (has_metis()) GTEST_SKIP() << "this build has METIS";
  const TetMesh mesh = make_box_mesh(3, 3, 3);
  try {
    static_cast<void>(order_by_parts(mesh));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("install libmetis-dev"), std::string::npos) << error.what();
  }
}

TEST(NewNumbers, of_a_refined_mesh_follow_those_of_the_coarse_one) {
  for (const MeshCase& c : reference::mesh_cases()) {
    SCOPED_TRACE(c.name);
    const Refined fine = refine(c.mesh, c.rest);
    const Renumbering coarse = random_numbering(c.mesh, reference::seed() * 1000003 + 15);
    const Renumbering numbers = refined_numbers(coarse, fine.parents);
    const TetMesh ordered = renumbered(fine.mesh, numbers);  // which checks that all are named once
    const std::vector<Index> place = new_numbers(coarse.node_order);
    const auto tets = in_order<std::array<Index, 4>>(c.mesh.tets, coarse.tet_order);
    Index before = -1;
    for (const Index old : numbers.node_order) {  // by the lower parent, which comes before its midpoints
      const auto [a, b] = fine.parents[at(old)];
      const Index lower = std::min(place[at(a)], place[at(b)]);
      ASSERT_GE(lower, before);
      if (lower > before) {
        ASSERT_EQ(a, b);
      }
      before = lower;
    }
    for (std::size_t t = 0; t < tets.size(); ++t) {  // eight tets within each coarse one
      for (std::size_t k = 0; k < 8; ++k) {
        for (const Index n : ordered.tets[8 * t + k]) {
          for (const Index parent : fine.parents[at(numbers.node_order[at(n)])]) {
            ASSERT_NE(std::ranges::find(tets[t], parent), tets[t].end());
          }
        }
      }
    }
  }
}

TEST(NewNumbers, of_patches_keep_their_tets_and_nodes) {
  for (const MeshCase& c : reference::mesh_cases()) {
    SCOPED_TRACE(c.name);
    const VolumePatches patches = greedy_patches(c.mesh);
    const Renumbering numbers = random_numbering(c.mesh, reference::seed() * 1000003 + 16);
    const TetMesh mesh = renumbered(c.mesh, numbers);
    const auto [fresh, order] = renumbered(patches, numbers);
    expect_permutation(order, patches.nodes.size());
    ASSERT_EQ(fresh.tet_patch.size(), mesh.tets.size());
    Index lowest = -1;
    for (std::size_t p = 0; p < order.size(); ++p) {
      const auto used = at(fresh.node_counts[p]);
      EXPECT_EQ(fresh.node_counts[p], patches.node_counts[at(order[p])]);
      const std::vector<Index> nodes(fresh.nodes[p].begin(),
                                     fresh.nodes[p].begin() + static_cast<std::ptrdiff_t>(used));
      EXPECT_TRUE(std::ranges::is_sorted(nodes));
      for (std::size_t s = used; s < 8; ++s) EXPECT_EQ(fresh.nodes[p][s], nodes[0]);
      std::set<Index> old_nodes, expected;
      for (const Index n : nodes) old_nodes.insert(numbers.node_order[at(n)]);
      for (std::size_t s = 0; s < used; ++s) expected.insert(patches.nodes[at(order[p])][s]);
      EXPECT_EQ(old_nodes, expected);
      const Index first = fresh.patch_tets.first[p], end = fresh.patch_tets.first[p + 1];
      EXPECT_GT(fresh.patch_tets.entries[at(first)].element, lowest);
      lowest = fresh.patch_tets.entries[at(first)].element;
      for (Index k = first; k < end; ++k) {
        const auto [tet, place] = fresh.patch_tets.entries[at(k)];
        EXPECT_EQ(place, k - first);
        EXPECT_EQ(fresh.tet_patch[at(tet)], static_cast<Index>(p));
        EXPECT_EQ(patches.tet_patch[at(numbers.tet_order[at(tet)])], order[p]);
      }
    }
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
      for (std::size_t k = 0; k < 4; ++k) {
        ASSERT_EQ(fresh.nodes[at(fresh.tet_patch[t])][fresh.tet_slots[t][k]], mesh.tets[t][k]);
      }
    }
  }
}

TEST(NewNumbers, of_a_group_are_those_of_its_members) {
  const MeshCase c = reference::box(4, 4, 4);
  MeshGroup group{"skin", {3, 7}, {{0, 1}}, boundary_faces(c.mesh), {5, 9}};
  complete(group, c.mesh.tets);
  const Renumbering numbers = random_numbering(c.mesh, reference::seed() * 1000003 + 17);
  const TetMesh mesh = renumbered(c.mesh, numbers);
  MeshGroup fresh = renumbered(group, mesh, numbers);
  // The same faces in the same sense, since both begin with the lowest node.
  std::vector<Face> faces = boundary_faces(mesh);
  std::ranges::sort(faces);
  EXPECT_EQ(fresh.faces, faces);
  EXPECT_TRUE(std::ranges::is_sorted(fresh.nodes));
  const Renumbering back{new_numbers(numbers.node_order), new_numbers(numbers.tet_order)};
  EXPECT_EQ(renumbered(fresh, c.mesh, back), group);
  EXPECT_NE(fresh, group);
}

TEST(NewNumbers, of_values_are_undone) {
  const std::vector<Index> order{2, 0, 3, 1};
  const std::vector<double> values{0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5};  // two each
  EXPECT_EQ(in_old_order<double>(values, order, 2), (std::vector<double>{1, 1.5, 3, 3.5, 0, 0.5, 2, 2.5}));
  const std::vector<double> single{10, 11, 12, 13};
  EXPECT_EQ(in_order<double>(single, order), (std::vector<double>{12, 10, 13, 11}));
  EXPECT_EQ(in_old_order<double>(in_order<double>(single, order), order), single);
}

}  // namespace
}  // namespace physgen::fem
