// What plates hold: whole faces, also of meshes whose faces are flat but for rounding, and words where that is in
// doubt.
#include <fem/mesh/graded_cube.h>
#include <fem/mesh/refine.h>
#include <fem/solver/hierarchy/hierarchy.h>
#include <gtest/gtest.h>
#include <physgen/error.h>
#include <truthcube/plates.h>

#include <algorithm>
#include <random>

namespace physgen::truthcube {
namespace {

using fem::Index;
using fem::MeshLevel;
using fem::Point;

constexpr double side = 0.08;  // [m]

/// A level by itself, as a user's mesh is, of 4^3 cells: a mean edge is 0.0248 m long.
std::vector<MeshLevel> given_mesh() {
  std::vector<MeshLevel> levels = fem::make_cube_levels(4, side, false);
  levels.resize(1);
  levels.front().parents.clear();
  return levels;
}

/// The same with each z off by up to `noise` [m].
std::vector<MeshLevel> rough_mesh(double noise, unsigned seed = 7) {
  std::vector<MeshLevel> levels = given_mesh();
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> off(-noise, noise);
  for (Point& x : levels.front().rest) x[2] += off(random);
  return levels;
}

/// The same with the mesh refined, finest first.
std::vector<MeshLevel> refined(std::vector<MeshLevel> levels) {
  fem::Refined finer = fem::refine(levels.front().mesh, levels.front().rest);
  MeshLevel level;
  level.mesh = std::move(finer.mesh);
  level.rest = std::move(finer.rest);
  level.parents = std::move(finer.parents);
  levels.insert(levels.begin(), std::move(level));
  return levels;
}

std::vector<Index> nodes_at(const MeshLevel& level, double z) {
  std::vector<Index> nodes;
  for (std::size_t n = 0; n < level.rest.size(); ++n) {
    if (level.rest[n][2] == z) nodes.push_back(static_cast<Index>(n));
  }
  return nodes;
}

TEST(Plates, hold_the_cubes_nodes_at_exactly_its_lowest_and_highest_z_on_every_level) {
  for (const int cells : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 20, 24}) {
    SCOPED_TRACE(cells);
    const auto levels = fem::make_cube_levels(cells, side, false);
    const PlatesOfBody plates = hold_between_plates(levels, default_plate_tolerance);
    for (std::size_t l = 0; l < levels.size(); ++l) {
      EXPECT_EQ(plates.lower.nodes[l], nodes_at(levels[l], 0));
      EXPECT_EQ(plates.upper.nodes[l], nodes_at(levels[l], plates.high));
      EXPECT_EQ(plates.upper.nodes[l].size(), plates.lower.nodes[l].size());
    }
    EXPECT_NEAR(plates.high, side, 1e-15);
    EXPECT_NEAR(plates.lower.area, side * side, 1e-12);
    EXPECT_NEAR(plates.upper.area, side * side, 1e-12);
    EXPECT_TRUE(warnings_of(plates).empty());
  }
}

TEST(Plates, know_the_mean_edge_of_a_box_without_its_lists) {
  for (const Index cells : {1, 3, 5, 7}) {
    std::vector<MeshLevel> levels = fem::make_cube_levels(cells, side, false);
    levels.resize(1);
    fem::grade_cube(levels.front().rest, cells, side, 2.5);
    const PlatesOfBody by_lists = hold_between_plates(levels, default_plate_tolerance);
    levels.front().mesh.edges = {};
    const PlatesOfBody without = hold_between_plates(levels, default_plate_tolerance);
    EXPECT_NEAR(without.mean_edge / by_lists.mean_edge, 1, 1e-14) << cells;
    EXPECT_EQ(without.lower.nodes, by_lists.lower.nodes);
    EXPECT_EQ(without.upper.nodes, by_lists.upper.nodes);
  }
}

TEST(Plates, hold_all_of_a_face_that_is_flat_but_for_rounding) {
  for (const double noise : {1e-12, 1e-10, 1e-9, 3e-9, 1e-8, 1e-7, 1e-6}) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const PlatesOfBody plates = hold_between_plates(rough_mesh(noise, seed), default_plate_tolerance);
      EXPECT_EQ(plates.lower.nodes[0].size(), 25u) << noise;
      EXPECT_EQ(plates.upper.nodes[0].size(), 25u) << noise;
      EXPECT_NEAR(plates.lower.area, side * side, 1e-8 * side * side);
      EXPECT_TRUE(warnings_of(plates).empty());
      EXPECT_NO_THROW(require_faces(plates));
    }
  }
}

TEST(Plates, of_a_refined_mesh_hold_the_nodes_between_those_that_they_hold) {
  const auto flat = hold_between_plates(refined(refined(given_mesh())), default_plate_tolerance);
  for (const double noise : {0.0, 1e-9, 1e-6}) {
    const auto levels = refined(refined(rough_mesh(noise)));
    const PlatesOfBody plates = hold_between_plates(levels, default_plate_tolerance);
    EXPECT_EQ(plates.lower.nodes, flat.lower.nodes);
    EXPECT_EQ(plates.upper.nodes, flat.upper.nodes);
    EXPECT_EQ(plates.lower.nodes[0].size(), 289u);
  }
  // The middle of an edge from a held node to one just beyond is not held, though it lies within the tolerance.
  auto rough = given_mesh();
  rough[0].rest[static_cast<std::size_t>(nodes_at(rough[0], 0)[12])][2] = 1.5e-4 * 0.0248;
  const auto levels = refined(rough);
  const PlatesOfBody plates = hold_between_plates(levels, default_plate_tolerance);
  EXPECT_EQ(plates.lower.nodes[1].size(), 24u);
  for (const Index n : plates.lower.nodes[0]) EXPECT_EQ(levels[0].rest[static_cast<std::size_t>(n)][2], 0);
}

TEST(Plates, say_that_nodes_lie_just_beyond_and_which_tolerance_holds_them) {
  auto levels = given_mesh();
  const std::vector<Index> top = nodes_at(levels[0], side);
  for (std::size_t k = 0; k < 5; ++k) levels[0].rest[static_cast<std::size_t>(top[k])][2] -= 4.15e-4 * 0.0248;
  const PlatesOfBody plates = hold_between_plates(levels, default_plate_tolerance);
  EXPECT_EQ(plates.upper.nodes[0].size(), 20u);
  EXPECT_EQ(plates.upper.just_beyond, 5);
  const std::vector<std::string> said = warnings_of(plates);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("the upper plate holds the 20 nodes"), std::string::npos) << said[0];
  EXPECT_NE(said[0].find("5 more nodes lie just beyond"), std::string::npos) << said[0];
  EXPECT_NE(said[0].find("--plate-tolerance 0.00042"), std::string::npos) << said[0];
  const PlatesOfBody wider = hold_between_plates(levels, 0.00042);
  EXPECT_EQ(wider.upper.nodes[0].size(), 25u);
  EXPECT_TRUE(warnings_of(wider).empty());
}

TEST(Plates, look_for_nodes_just_beyond_as_far_as_ten_tolerances_but_not_into_the_next_layer) {
  auto levels = given_mesh();
  double& z = levels[0].rest[static_cast<std::size_t>(nodes_at(levels[0], 0)[12])][2];
  const auto beyond = [&](double edges, double tolerance) {
    z = edges * 0.0248;
    return hold_between_plates(levels, tolerance).lower.just_beyond;
  };
  EXPECT_EQ(beyond(9e-4, default_plate_tolerance), 1);
  EXPECT_EQ(beyond(1.1e-3, default_plate_tolerance), 0);
  EXPECT_EQ(beyond(9e-4, 0), 1);  // as far as ten times the default where less is asked for
  EXPECT_EQ(beyond(0.09, 0.01), 1);
  EXPECT_EQ(beyond(0.11, 0.01), 0);
  EXPECT_EQ(beyond(0, largest_plate_tolerance), 0);
  EXPECT_EQ(beyond(0, 0), 0);
}

TEST(Plates, say_that_a_tet_is_thinner_than_their_tolerance) {
  auto levels = given_mesh();
  for (Point& x : levels[0].rest) {
    if (x[2] == side / 4) x[2] = 1e-6;
  }
  const std::vector<std::string> said = warnings_of(hold_between_plates(levels, default_plate_tolerance));
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("the lower plate holds all corners of 96 tets"), std::string::npos) << said[0];
}

TEST(Plates, of_a_body_without_flat_faces_are_refused_with_what_lies_just_beyond) {
  const PlatesOfBody plates = hold_between_plates(rough_mesh(1e-5), 1e-8);
  try {
    require_faces(plates);
    FAIL() << "not refused";
  } catch (const Error& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("These are only 1 and 1, with 24 and 24 more just beyond"), std::string::npos) << said;
    EXPECT_NE(said.find("--plate-tolerance"), std::string::npos) << said;
  }
}

TEST(Plates, are_described_by_their_nodes_and_areas) {
  EXPECT_EQ(describe(hold_between_plates(given_mesh(), default_plate_tolerance)),
            "plates hold 25 and 25 nodes, 6400 and 6400 mm^2 of the surface (lower and upper)");
}

}  // namespace
}  // namespace physgen::truthcube
