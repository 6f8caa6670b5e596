// Cubes whose cells narrow towards all faces.
#include <fem/mesh/flatness.h>
#include <fem/mesh/geometry.h>
#include <fem/mesh/graded_cube.h>
#include <fem/mesh/mesh.h>
#include <gtest/gtest.h>

#include <cmath>

namespace physgen::fem {
namespace {

constexpr double side = 0.08;

TEST(GradedCube, positions_follow_the_power_and_are_mirrored) {
  for (const double grading : {1.0, 1.25, 1.5, 2.0, 2.5}) {
    for (const Index cells : {1, 2, 3, 5, 8, 16, 31}) {
      const std::vector<double> at = graded_positions(cells, side, grading);
      ASSERT_EQ(at.size(), static_cast<std::size_t>(cells) + 1);
      EXPECT_EQ(at.front(), 0);
      EXPECT_EQ(at.back(), side);
      for (std::size_t k = 0; k < at.size(); ++k) {
        EXPECT_DOUBLE_EQ(at[k] + at[at.size() - 1 - k], side) << cells << " cells, " << k;
        if (2 * k > at.size() - 1) continue;
        EXPECT_NEAR(at[k], side / 2 * std::pow(2. * double(k) / cells, grading), 1e-17) << cells << " cells, " << k;
      }
      if (cells % 2 != 0) continue;
      EXPECT_EQ(at[static_cast<std::size_t>(cells / 2)], side / 2);
    }
  }
}

TEST(GradedCube, half_as_many_cells_have_every_second_position_to_the_last_bit) {
  for (const double grading : {1.25, 1.5, 1.75}) {
    const std::vector<double> fine = graded_positions(48, side, grading), coarse = graded_positions(24, side, grading);
    for (std::size_t k = 0; k < coarse.size(); ++k) EXPECT_EQ(fine[2 * k], coarse[k]) << k;
  }
}

std::vector<Point> uniform(Index cells) {
  std::vector<Point> rest;
  const auto at = [=](Index k) { return side * (double(k) / cells); };
  for (Index z = 0; z <= cells; ++z) {
    for (Index y = 0; y <= cells; ++y) {
      for (Index x = 0; x <= cells; ++x) rest.push_back({at(x), at(y), at(z)});
    }
  }
  return rest;
}

TEST(GradedCube, nodes_keep_their_places_in_the_grid_and_no_cell_is_flat) {
  constexpr Index cells = 12;
  const TetMesh mesh = make_box_mesh(cells, cells, cells, {6, 6, 6});
  for (const double grading : {1.5, 2.0}) {
    std::vector<Point> rest = uniform(cells);
    grade_cube(rest, cells, side, grading);
    const std::vector<double> at = graded_positions(cells, side, grading);
    std::size_t node = 0;
    for (std::size_t z = 0; z < at.size(); ++z) {
      for (std::size_t y = 0; y < at.size(); ++y) {
        for (std::size_t x = 0; x < at.size(); ++x) EXPECT_EQ(rest[node++], (Point{at[x], at[y], at[z]}));
      }
    }
    const double narrowest = at[1], widest = at[6] - at[5];
    EXPECT_NEAR(graded_flatness(cells, grading), widest / narrowest, 1e-12);
    double volume = 0, smallest = 1;
    for (const auto& tet : mesh.tets) {
      volume += six_volumes(tet, rest) / 6;
      smallest = std::min(smallest, six_volumes(tet, rest));
    }
    EXPECT_NEAR(volume / std::pow(side, 3), 1, 1e-13);
    EXPECT_NEAR(smallest / std::pow(narrowest, 3), 1, 1e-12);
  }
}

TEST(GradedCube, a_grading_of_one_moves_no_node) {
  std::vector<Point> rest = uniform(7);
  const std::vector<Point> before = rest;
  grade_cube(rest, 7, side, 1);
  EXPECT_EQ(rest, before);
  EXPECT_NEAR(graded_flatness(7, 1), 1, 1e-14);
}

TEST(GradedCube, is_as_flat_as_99_of_100_of_its_tets) {
  constexpr Index cells = 6;
  const TetMesh mesh = make_box_mesh(cells, cells, cells);
  std::vector<Point> rest = uniform(cells);
  EXPECT_NEAR(flatness(mesh, rest), 1, 1e-12);
  std::vector<Point> pressed = rest;
  for (Point& x : pressed) x[2] /= 6;
  EXPECT_NEAR(flatness(mesh, pressed), std::pow(2 + 1 / 36., 1.5) * 6 / std::pow(3, 1.5), 1e-12);
  for (Point& x : rest) x = {-x[1], x[0], x[2]};  // turned, and seen in a mirror below
  EXPECT_NEAR(flatness(mesh, rest), 1, 1e-12);
  for (Point& x : rest) x[0] = -x[0];
  EXPECT_NEAR(flatness(mesh, rest), 1, 1e-12);
  // The corner of the cube, pressed into its cell: 6 of 1296 tets are flat, fewer than 1 in 100.
  rest = uniform(cells);
  rest.front() = {0.2 * side / cells, 0.2 * side / cells, 0.3 * side / cells};
  EXPECT_NEAR(flatness(mesh, rest), 1, 1e-12);
  EXPECT_EQ(flatness(TetMesh{}, {}), 0);
  std::vector<Point> graded = uniform(32);
  grade_cube(graded, 32, side, 1.5);
  const double flat = flatness(make_box_mesh(32, 32, 32), graded);
  EXPECT_GT(flat, 3.5);
  EXPECT_LT(flat, 4.5);
}

}  // namespace
}  // namespace physgen::fem
