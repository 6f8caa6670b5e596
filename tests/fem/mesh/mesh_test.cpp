// Box meshes, their edges and incidence lists, and the Truth Cube.
#include <fem/mesh/mesh.h>
#include <fem/mesh/truth_cube.h>
#include <gtest/gtest.h>
#include <physgen/error.h>

#include <Eigen/Dense>
#include <algorithm>
#include <map>
#include <set>

namespace physgen::fem {
namespace {

Eigen::Matrix3d edges_of(const std::array<Index, 4>& tet, const std::vector<Point>& x) {
  Eigen::Matrix3d d;
  for (int c = 0; c < 3; ++c) {
    for (int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      d(k, c) = x[static_cast<std::size_t>(tet[static_cast<std::size_t>(c) + 1])][axis] -
                x[static_cast<std::size_t>(tet[0])][axis];
    }
  }
  return d;
}

TEST(BoxMesh, fills_the_box_with_tets_of_equal_positive_volume) {
  const TruthCube cube = make_truth_cube(5, 1);
  ASSERT_EQ(cube.mesh.tets.size(), 6u * 125u);
  ASSERT_EQ(cube.rest.size(), 216u);
  const double cell = std::pow(TruthCube::side / 5, 3);
  for (const auto& tet : cube.mesh.tets) EXPECT_NEAR(edges_of(tet, cube.rest).determinant(), cell, 1e-12 * cell);
}

// Counts the boundary faces of a mesh none of whose faces belongs to more than two tets.
int boundary_faces(const TetMesh& mesh) {
  std::map<std::array<Index, 3>, int> faces;
  for (const auto& tet : mesh.tets) {
    for (std::size_t skip = 0; skip < 4; ++skip) {
      std::array<Index, 3> face{};
      for (std::size_t c = 0, k = 0; c < 4; ++c) {
        if (c != skip) face[k++] = tet[c];
      }
      std::sort(face.begin(), face.end());
      ++faces[face];
    }
  }
  int boundary = 0;
  for (const auto& [face, count] : faces) {
    EXPECT_LE(count, 2);
    boundary += count == 1;
  }
  return boundary;
}

TEST(BoxMesh, is_conforming) {
  for (const MirroredFrom& mirrored : {MirroredFrom{}, {1, 2, 1}, {2, 5, 0}, {0, 0, 0}, {3, 4, 1}}) {
    EXPECT_EQ(boundary_faces(make_box_mesh(3, 4, 2, mirrored)), 2 * 2 * (3 * 4 + 3 * 2 + 4 * 2));
  }
}

TEST(BoxMesh, is_its_own_mirror_image_where_half_of_its_cells_are_mirrored_along_each_axis) {
  constexpr Index nx = 4, ny = 6, nz = 2;
  const auto tets_of = [](const TetMesh& mesh, const auto& place) {
    std::set<std::array<Index, 4>> tets;
    for (std::array<Index, 4> tet : mesh.tets) {
      for (Index& node : tet) node = place(node % (nx + 1), node / (nx + 1) % (ny + 1), node / (nx + 1) / (ny + 1));
      std::ranges::sort(tet);
      tets.insert(tet);
    }
    return tets;
  };
  const auto node = [](Index x, Index y, Index z) { return x + (nx + 1) * (y + (ny + 1) * z); };
  const auto across_x = [&](Index x, Index y, Index z) { return node(nx - x, y, z); };
  const auto across_y = [&](Index x, Index y, Index z) { return node(x, ny - y, z); };
  const auto across_z = [&](Index x, Index y, Index z) { return node(x, y, nz - z); };
  const TetMesh mesh = make_box_mesh(nx, ny, nz, {nx / 2, ny / 2, nz / 2}), plain = make_box_mesh(nx, ny, nz);
  EXPECT_EQ(tets_of(mesh, node), tets_of(mesh, across_x));
  EXPECT_EQ(tets_of(mesh, node), tets_of(mesh, across_y));
  EXPECT_EQ(tets_of(mesh, node), tets_of(mesh, across_z));
  EXPECT_NE(tets_of(plain, node), tets_of(plain, across_x));
  EXPECT_NE(tets_of(plain, node), tets_of(plain, across_y));
  EXPECT_NE(tets_of(plain, node), tets_of(plain, across_z));
  std::vector<Point> rest;
  for (Index n = 0; n < mesh.nodes; ++n) {
    rest.push_back({double(n % (nx + 1)), double(n / (nx + 1) % (ny + 1)), double(n / (nx + 1) / (ny + 1))});
  }
  for (const auto& tet : mesh.tets) EXPECT_NEAR(edges_of(tet, rest).determinant(), 1, 1e-12);
}

TEST(BoxMesh, lists_every_edge_once_in_order) {
  const TetMesh mesh = make_box_mesh(4, 3, 2);
  std::set<std::array<Index, 2>> expected;
  for (const auto& tet : mesh.tets) {
    for (const auto& [a, b] : tet_edges) {
      const Index m = tet[static_cast<std::size_t>(a)], n = tet[static_cast<std::size_t>(b)];
      expected.insert({std::min(m, n), std::max(m, n)});
    }
  }
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), mesh.edges.begin(), mesh.edges.end()));
}

TEST(BoxMesh, has_incidence_lists_that_name_each_use_once) {
  const TetMesh mesh = make_box_mesh(3, 2, 4);
  const auto range = [](const IncidenceList& list, std::size_t i) {
    return std::vector<IncidenceEntry>(list.entries.begin() + list.first[i], list.entries.begin() + list.first[i + 1]);
  };
  ASSERT_EQ(mesh.node_tets.entries.size(), 4 * mesh.tets.size());
  ASSERT_EQ(mesh.node_edges.entries.size(), 2 * mesh.edges.size());
  ASSERT_EQ(mesh.edge_tets.entries.size(), 6 * mesh.tets.size());
  for (Index node = 0; node < mesh.nodes; ++node) {
    const auto tets = range(mesh.node_tets, static_cast<std::size_t>(node));
    EXPECT_TRUE(std::is_sorted(tets.begin(), tets.end()));
    for (const auto [tet, corner] : tets) EXPECT_EQ(mesh.tets[std::size_t(tet)][std::size_t(corner)], node);
    for (const auto [edge, side] : range(mesh.node_edges, static_cast<std::size_t>(node))) {
      EXPECT_EQ(mesh.edges[std::size_t(edge)][std::size_t(side)], node);
    }
  }
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto tets = range(mesh.edge_tets, e);
    EXPECT_TRUE(std::is_sorted(tets.begin(), tets.end()));
    for (const auto [element, local] : tets) {
      const auto& tet = mesh.tets[std::size_t(element)];
      const auto [a, b] = tet_edges[std::size_t(local % 6)];
      const bool flipped = local >= 6;
      EXPECT_EQ(tet[std::size_t(flipped ? b : a)], mesh.edges[e][0]);
      EXPECT_EQ(tet[std::size_t(flipped ? a : b)], mesh.edges[e][1]);
    }
  }
}

TEST(TetMesh, refuses_bad_input_with_its_place) {
  EXPECT_THROW(make_tet_mesh(4, {{0, 1, 2, 4}}), Error);
  EXPECT_THROW(make_tet_mesh(4, {{0, 1, 2, -1}}), Error);
  EXPECT_THROW(make_tet_mesh(4, {{0, 1, 2, 2}}), Error);
  EXPECT_THROW(make_box_mesh(0, 1, 1), Error);
  EXPECT_THROW(make_box_mesh(1, -3, 1), Error);
  EXPECT_THROW(make_box_mesh(100000, 100000, 100000), Error);
}

TEST(TetMesh, may_be_empty) {
  const TetMesh mesh = make_tet_mesh(3, {});
  EXPECT_TRUE(mesh.edges.empty());
  EXPECT_EQ(mesh.node_tets.first, std::vector<Index>(4, 0));
  EXPECT_EQ(mesh.edge_tets.first, std::vector<Index>(1, 0));
}

TEST(TruthCube, is_compressed_between_flat_plates_without_inverting_a_tet) {
  const TruthCube cube = make_truth_cube(8, 42);
  for (std::size_t i = 0; i < cube.rest.size(); ++i) {
    if (cube.rest[i][2] == 0) {
      EXPECT_EQ(cube.deformed[i], cube.rest[i]);
    } else if (cube.rest[i][2] == TruthCube::side) {
      EXPECT_NEAR(cube.deformed[i][2], 0.07, 1e-15);
    }
  }
  double least = 10, most = 0, volume = 0;
  for (const auto& tet : cube.mesh.tets) {
    const double v = edges_of(tet, cube.deformed).determinant(), J = v / edges_of(tet, cube.rest).determinant();
    least = std::min(least, J), most = std::max(most, J), volume += v / 6;
  }
  EXPECT_GT(least, 0.6);
  EXPECT_LT(most, 1.3);
  EXPECT_NEAR(volume, std::pow(TruthCube::side, 3), 0.01 * std::pow(TruthCube::side, 3));
}

TEST(TruthCube, depends_on_its_seed_alone) {
  EXPECT_EQ(make_truth_cube(4, 7).deformed, make_truth_cube(4, 7).deformed);
  EXPECT_NE(make_truth_cube(4, 7).deformed, make_truth_cube(4, 8).deformed);
}

}  // namespace
}  // namespace physgen::fem
