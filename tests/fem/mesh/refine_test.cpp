// Refinement: parents that are edges, volumes of an eighth, conforming, and Kuhn meshes from Kuhn meshes.
#include <fem/mesh/at.h>
#include <fem/mesh/refine.h>
#include <gtest/gtest.h>
#include <physgen/error.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "mesh_cases.h"

namespace physgen::fem {
namespace {

Point middle(const Point& a, const Point& b) { return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2}; }

// Every pair is a node, or an edge, of the coarse mesh, and its middle is where the fine node is.
void expect_parents(const TetMesh& coarse, const std::vector<Point>& coarse_rest,
                    const std::vector<std::array<Index, 2>>& parents, const std::vector<Point>& fine_rest) {
  ASSERT_EQ(parents.size(), fine_rest.size());
  std::vector<int> uses(coarse.edges.size());
  std::size_t kept = 0;
  for (std::size_t v = 0; v < parents.size(); ++v) {
    const auto [a, b] = parents[v];
    ASSERT_TRUE(a >= 0 && a <= b && b < coarse.nodes) << v;
    EXPECT_EQ(fine_rest[v], middle(coarse_rest[at(a)], coarse_rest[at(b)])) << v;
    if (a == b) {
      ++kept;
      continue;
    }
    const auto edge = std::ranges::lower_bound(coarse.edges, parents[v]);
    ASSERT_TRUE(edge != coarse.edges.end() && *edge == parents[v]) << a << " " << b << " is no edge";
    ++uses[static_cast<std::size_t>(edge - coarse.edges.begin())];
  }
  EXPECT_EQ(kept, at(coarse.nodes));
  EXPECT_TRUE(std::ranges::all_of(uses, [](int count) { return count == 1; })) << "each edge has one midpoint";
}

// Tets as sets of positions: what a mesh is apart from its numbers.
std::set<std::array<Point, 4>> shapes(const TetMesh& mesh, const std::vector<Point>& rest) {
  std::set<std::array<Point, 4>> result;
  for (const auto& tet : mesh.tets) {
    std::array<Point, 4> corners{rest[at(tet[0])], rest[at(tet[1])], rest[at(tet[2])], rest[at(tet[3])]};
    std::ranges::sort(corners);
    result.insert(corners);
  }
  return result;
}

TEST(BoxParents, are_edges_of_the_coarse_box_whose_midpoints_are_the_fine_nodes) {
  for (const auto& [nx, ny, nz] : {std::array{1, 1, 1}, {3, 2, 4}, {1, 5, 2}, {6, 6, 6}}) {
    SCOPED_TRACE(testing::Message() << nx << " x " << ny << " x " << nz);
    const auto coarse = reference::box(nx, ny, nz, {2, 2, 2}), fine = reference::box(2 * nx, 2 * ny, 2 * nz);
    expect_parents(coarse.mesh, coarse.rest, box_parents(nx, ny, nz), fine.rest);
    const MirroredFrom mirrored{nx / 2, ny - 1, nz / 2};
    const TetMesh other = make_box_mesh(nx, ny, nz, mirrored);
    expect_parents(other, coarse.rest, box_parents(nx, ny, nz, mirrored), fine.rest);
  }
}

TEST(BoxParents, refuse_what_is_no_box_or_too_large) {
  EXPECT_THROW(static_cast<void>(box_parents(0, 1, 1)), Error);
  EXPECT_THROW(static_cast<void>(box_parents(1, -2, 1)), Error);
  EXPECT_THROW(static_cast<void>(box_parents(200, 200, 200)), Error);  // its fine box has 384 million tets
}

TEST(Refinement, keeps_nodes_and_puts_new_ones_on_the_middle_of_edges_in_their_order) {
  for (const auto& [name, mesh, rest] : reference::mesh_cases()) {
    SCOPED_TRACE(name);
    const Refined fine = refine(mesh, rest);
    expect_parents(mesh, rest, fine.parents, fine.rest);
    for (Index v = 0; v < mesh.nodes; ++v) EXPECT_EQ(fine.parents[at(v)], (std::array{v, v}));
    EXPECT_TRUE(std::equal(mesh.edges.begin(), mesh.edges.end(), fine.parents.begin() + mesh.nodes));
    EXPECT_EQ(fine.mesh.nodes, static_cast<Index>(fine.rest.size()));
  }
}

TEST(Refinement, cuts_each_tet_into_eight_of_an_eighth_of_its_volume) {
  for (const auto& [name, mesh, rest] : reference::mesh_cases()) {
    SCOPED_TRACE(name);
    const Refined fine = refine(mesh, rest);
    ASSERT_EQ(fine.mesh.tets.size(), 8 * mesh.tets.size());
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
      const double eighth = six_volumes(mesh.tets[t], rest) / 8;
      ASSERT_GT(eighth, 0);
      for (std::size_t k = 0; k < 8; ++k) {
        EXPECT_NEAR(six_volumes(fine.mesh.tets[8 * t + k], fine.rest), eighth, 1e-13) << t << " part " << k;
        for (const Index node : fine.mesh.tets[8 * t + k]) {
          for (const Index parent : fine.parents[at(node)]) {
            EXPECT_NE(std::ranges::find(mesh.tets[t], parent), mesh.tets[t].end()) << "a part leaves its tet";
          }
        }
      }
    }
  }
}

TEST(Refinement, keeps_a_negative_sign_of_volume) {
  auto given = reference::random_tet(21);
  std::swap(given.mesh.tets[0][2], given.mesh.tets[0][3]);
  const Refined fine = refine(make_tet_mesh(4, given.mesh.tets), given.rest);
  for (const auto& tet : fine.mesh.tets) EXPECT_LT(six_volumes(tet, fine.rest), 0);
}

TEST(Refinement, is_conforming_with_four_boundary_faces_for_each_and_the_same_topology) {
  const auto faces = [](const TetMesh& mesh) {
    std::map<std::array<Index, 3>, int> uses;
    for (const auto& tet : mesh.tets) {
      for (std::size_t skip = 0; skip < 4; ++skip) {
        std::array<Index, 3> face{tet[(skip + 1) % 4], tet[(skip + 2) % 4], tet[(skip + 3) % 4]};
        std::ranges::sort(face);
        ++uses[face];
      }
    }
    std::array<std::size_t, 3> with{};  // faces of one tet, of two, of more
    for (const auto& [face, count] : uses) ++with[std::min<std::size_t>(at(count), 3) - 1];
    return with;
  };
  for (const auto& [name, mesh, rest] : reference::mesh_cases()) {
    SCOPED_TRACE(name);
    const Refined fine = refine(mesh, rest);
    const auto before = faces(mesh), after = faces(fine.mesh);
    EXPECT_EQ(after[0], 4 * before[0]);
    EXPECT_EQ(after[1], 4 * before[1] + 8 * mesh.tets.size());
    EXPECT_EQ(after[2], 0u);
    EXPECT_EQ(reference::euler_characteristic(fine.mesh), reference::euler_characteristic(mesh));
  }
}

TEST(Refinement, makes_the_kuhn_mesh_of_half_the_cell_from_a_kuhn_mesh_again_and_again) {
  for (const Point& cell : {Point{4, 4, 4}, {4, 64, 8}, {128, 4, 12}}) {
    const auto coarse = reference::box(2, 3, 1, cell);
    const Refined once = refine(coarse.mesh, coarse.rest), twice = refine(once.mesh, once.rest);
    const auto half = reference::box(4, 6, 2, {cell[0] / 2, cell[1] / 2, cell[2] / 2});
    const auto quarter = reference::box(8, 12, 4, {cell[0] / 4, cell[1] / 4, cell[2] / 4});
    EXPECT_EQ(shapes(once.mesh, once.rest), shapes(half.mesh, half.rest));
    EXPECT_EQ(shapes(twice.mesh, twice.rest), shapes(quarter.mesh, quarter.rest));
  }
}

TEST(Refinement, gives_boxes_the_parents_that_box_parents_names) {
  const auto coarse = reference::box(3, 2, 2, {2, 2, 2}), fine = reference::box(6, 4, 4);
  const Refined refined = refine(coarse.mesh, coarse.rest);
  std::map<Point, std::array<Index, 2>> by_place;
  for (std::size_t v = 0; v < refined.rest.size(); ++v) by_place[refined.rest[v]] = refined.parents[v];
  const auto parents = box_parents(3, 2, 2);
  for (std::size_t v = 0; v < fine.rest.size(); ++v) EXPECT_EQ(by_place.at(fine.rest[v]), parents[v]);
}

// Squared lengths of edges, four times as much after each refinement, tell shapes apart. Corners on a lattice of
// spacing 64 keep the arithmetic exact, and many edges perpendicular to others.
TEST(Refinement, makes_three_shapes_of_each_tet_and_no_more_however_often_one_refines) {
  auto random = reference::random_stream(22);
  for (int repeat = 0; repeat < 30; ++repeat) {
    std::vector<Point> rest(4);
    TetMesh mesh = make_tet_mesh(4, {{0, 1, 2, 3}});
    do {
      for (Point& x : rest) {
        for (double& coordinate : x) coordinate = 64 * static_cast<double>(random() % (repeat < 15 ? 3 : 100));
      }
    } while (six_volumes(mesh.tets[0], rest) == 0);
    std::set<std::array<double, 6>> classes;
    double scale = 1;
    for (int level = 0; level < 5; ++level, scale *= 4) {
      for (const auto& tet : mesh.tets) {
        std::array<double, 6> squares{};
        for (std::size_t e = 0; e < 6; ++e) {
          const auto [a, b] = tet_edges[e];
          const Point edge = difference(rest[at(tet[at(b)])], rest[at(tet[at(a)])]);
          squares[e] = scale * dot(edge, edge);
        }
        std::ranges::sort(squares);
        classes.insert(squares);
      }
      Refined fine = refine(mesh, rest);
      mesh = std::move(fine.mesh);
      rest = std::move(fine.rest);
    }
    EXPECT_LE(classes.size(), 3u);
  }
}

TEST(Refinement, keeps_nodes_of_no_tet_and_takes_a_mesh_without_tets) {
  const std::vector<Point> rest{{0, 0, 0}, {1, 0, 0}};
  const Refined fine = refine(make_tet_mesh(2, {}), rest);
  EXPECT_EQ(fine.rest, rest);
  EXPECT_EQ(fine.mesh.nodes, 2);
  EXPECT_EQ(fine.parents, (std::vector<std::array<Index, 2>>{{0, 0}, {1, 1}}));
}

TEST(Refinement, refuses_positions_of_another_number) {
  EXPECT_THROW(static_cast<void>(refine(make_tet_mesh(4, {{0, 1, 2, 3}}), std::vector<Point>(3))), Error);
}

}  // namespace
}  // namespace physgen::fem
