// Points in tets: found where they are, by each of several meshes, and refused when they are in none.
#include <fem/mesh/locate.h>
#include <fem/mesh/renumber.h>
#include <fem/mesh/truth_cube.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "reference.h"

namespace physgen::fem {
namespace {

std::vector<Point> random_points(std::size_t count, double low, double high, unsigned stream) {
  std::mt19937_64 engine(reference::seed() * 1000003 + stream);
  std::uniform_real_distribution<double> uniform(low, high);
  std::vector<Point> points(count);
  for (Point& x : points) {
    for (double& coordinate : x) coordinate = uniform(engine);
  }
  return points;
}

// The deformed cube: an irregular mesh without inverted tets.
struct Irregular {
  TruthCube cube = make_truth_cube(6, 17);
  const TetMesh& mesh = cube.mesh;
  const std::vector<Point>& positions = cube.deformed;
};

void expect_found(std::span<const Point> positions, const TetMesh& mesh, std::span<const Point> points) {
  double size = 0;
  for (const Point& x : positions) size = std::max({size, std::abs(x[0]), std::abs(x[1]), std::abs(x[2])});
  const std::vector<Location> found = locate(positions, mesh, points);
  ASSERT_EQ(found.size(), points.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    Point x{};
    double sum = 0;
    for (std::size_t c = 0; c < 4; ++c) {
      const double weight = found[p].weights[c];
      EXPECT_GE(weight, -locate_tolerance);
      sum += weight;
      const auto node = static_cast<std::size_t>(mesh.tets[static_cast<std::size_t>(found[p].tet)][c]);
      for (std::size_t k = 0; k < 3; ++k) x[k] += weight * positions[node][k];
    }
    EXPECT_NEAR(sum, 1, 1e-14);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(x[k], points[p][k], 1e-13 * size) << "point " << p;
  }
}

TEST(Locate, finds_random_points_in_an_irregular_mesh) {
  const Irregular irregular;
  expect_found(irregular.positions, irregular.mesh, random_points(2000, 0.005, 0.065, 1));
}

TEST(Locate, finds_every_node_and_every_middle_of_a_tet) {
  const Irregular irregular;
  expect_found(irregular.positions, irregular.mesh, irregular.positions);
  std::vector<Point> middles;
  for (const std::array<Index, 4>& tet : irregular.mesh.tets) {
    Point& middle = middles.emplace_back();
    for (const Index node : tet) {
      for (std::size_t k = 0; k < 3; ++k) middle[k] += irregular.positions[static_cast<std::size_t>(node)][k] / 4;
    }
  }
  const std::vector<Location> found = locate(irregular.positions, irregular.mesh, middles);
  for (std::size_t t = 0; t < found.size(); ++t) {
    EXPECT_EQ(found[t].tet, static_cast<Index>(t));
    for (const double weight : found[t].weights) EXPECT_NEAR(weight, 0.25, 1e-12);
  }
}

TEST(Locate, finds_points_in_meshes_of_any_scale_and_place) {
  const Irregular irregular;
  for (const double scale : {1e-9, 1., 1e9}) {
    for (const double shift : {0., 1e3}) {
      std::vector<Point> positions = irregular.positions, points = random_points(200, 0.005, 0.065, 2);
      for (std::vector<Point>* all : {&positions, &points}) {
        for (Point& x : *all) {
          for (double& coordinate : x) coordinate = scale * (coordinate + shift);
        }
      }
      expect_found(positions, irregular.mesh, points);
    }
  }
}

TEST(Locate, takes_the_first_of_the_tets_that_share_a_point_in_the_same_depth) {
  const TruthCube cube = make_truth_cube(2, 1);
  const std::vector<Location> found = locate(cube.rest, cube.mesh, cube.rest);
  for (std::size_t n = 0; n < found.size(); ++n) {
    const std::array<Index, 4>& corners = cube.mesh.tets[static_cast<std::size_t>(found[n].tet)];
    EXPECT_EQ(found[n].tet,
              cube.mesh.node_tets.entries[static_cast<std::size_t>(cube.mesh.node_tets.first[n])].element);
    EXPECT_NE(std::find(corners.begin(), corners.end(), static_cast<Index>(n)), corners.end());
  }
}

TEST(Locate, finds_points_in_inverted_tets_and_passes_flat_ones_by) {
  const std::vector<Point> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0.5, 0}};
  const TetMesh mesh = make_tet_mesh(5, {{0, 1, 2, 4}, {1, 0, 2, 3}});  // of no and of negative volume
  const std::vector<Point> points{{0.25, 0.25, 0}, {0.1, 0.2, 0.3}};
  expect_found(positions, mesh, points);
  for (const Location& location : locate(positions, mesh, points)) EXPECT_EQ(location.tet, 1);
}

TEST(Locate, finds_points_of_a_plane_of_a_line_and_none) {
  const TruthCube cube = make_truth_cube(3, 1);
  std::vector<Point> points = random_points(50, 0, 0.08, 3);
  for (Point& x : points) x[2] = 0.08;
  expect_found(cube.rest, cube.mesh, points);
  for (Point& x : points) x[0] = 0;
  expect_found(cube.rest, cube.mesh, points);
  EXPECT_TRUE(locate(cube.rest, cube.mesh, {}).empty());
}

TEST(Locate, accepts_points_outside_by_rounding_and_names_the_first_of_those_that_are_farther) {
  const TruthCube cube = make_truth_cube(4, 1);  // cells of 0.02 m
  std::vector<Point> points = random_points(10, 0, 0.08, 4);
  points[6][1] = 0.08 + 1e-9;
  EXPECT_EQ(locate(cube.rest, cube.mesh, points).size(), points.size());
  points[6][1] = 0.08 + 1e-6;
  points[8] = {1, 2, 3};
  try {
    static_cast<void>(locate(cube.rest, cube.mesh, points));
    ADD_FAILURE() << "no error";
  } catch (const OutsideMesh& error) {
    EXPECT_EQ(error.point(), 6U);
    EXPECT_NE(std::string(error.what()).find("point 6 ("), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("between (0, 0, 0) and (0.08, 0.08, 0.08)"), std::string::npos)
        << error.what();
  }
}

TEST(Locate, refuses_points_that_are_not_finite) {
  const TruthCube cube = make_truth_cube(1, 1);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const std::vector<Point> points{{0.01, 0.01, 0.01}, {0.01, bad, 0.01}};
    try {
      static_cast<void>(locate(cube.rest, cube.mesh, points));
      ADD_FAILURE() << "no error";
    } catch (const OutsideMesh& error) {
      EXPECT_EQ(error.point(), 1U);
    }
  }
}

TEST(Locate, refuses_positions_that_are_not_one_for_each_node) {
  const TruthCube cube = make_truth_cube(1, 1);
  EXPECT_THROW(static_cast<void>(locate(std::span(cube.rest).first(7), cube.mesh, {})), Error);
}

}  // namespace
}  // namespace physgen::fem
