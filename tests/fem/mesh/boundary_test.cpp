// Surfaces and loads: closed, outward, and with the resultants that mechanics demands.
#include <fem/mesh/at.h>
#include <fem/mesh/boundary.h>
#include <gtest/gtest.h>
#include <physgen/error.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "mesh_cases.h"

namespace physgen::fem {
namespace {

using reference::MeshCase;

Point twice_area(const Face& face, const std::vector<Point>& x) {
  return cross(difference(x[at(face[1])], x[at(face[0])]), difference(x[at(face[2])], x[at(face[0])]));
}

Point sum_of(const std::vector<Force>& forces) {
  Point sum{};
  for (const Force& f : forces) {
    for (std::size_t k = 0; k < 3; ++k) sum[k] += f[k];
  }
  return sum;
}

Point torque_of(const std::vector<Force>& forces, const std::vector<Point>& x) {
  std::vector<Force> torques;
  torques.reserve(x.size());
  for (std::size_t n = 0; n < x.size(); ++n) torques.push_back(cross(x[n], forces[n]));
  return sum_of(torques);
}

void expect_near(const Point& value, const Point& expected, double tolerance) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(value[k], expected[k], tolerance) << "component " << k;
}

TEST(BoundaryFaces, of_a_box_are_two_per_cell_at_its_sides) {
  EXPECT_EQ(boundary_faces(make_box_mesh(3, 4, 2)).size(), 2u * 2u * (3u * 4u + 3u * 2u + 4u * 2u));
  EXPECT_EQ(boundary_faces(make_tet_mesh(4, {{0, 1, 2, 3}})).size(), 4u);
  EXPECT_TRUE(boundary_faces(make_tet_mesh(4, {})).empty());
}

TEST(BoundaryFaces, are_a_closed_surface) {
  for (const auto& [name, mesh, rest] : reference::mesh_cases()) {
    SCOPED_TRACE(name);
    std::map<std::array<Index, 2>, int> directed;
    for (const Face& face : boundary_faces(mesh)) {
      for (std::size_t c = 0; c < 3; ++c) ++directed[{face[c], face[(c + 1) % 3]}];
    }
    for (const auto& [edge, count] : directed) {
      EXPECT_EQ(count, 1);
      EXPECT_TRUE(directed.contains({edge[1], edge[0]})) << "the face at the other side turns the other way";
    }
  }
}

TEST(BoundaryFaces, have_normals_that_sum_to_zero_and_point_outward) {
  for (const auto& [name, mesh, rest] : reference::mesh_cases()) {
    SCOPED_TRACE(name);
    Point sum{};
    double volume = 0;  // the divergence theorem: the integral of x . n / 3
    for (const Face& face : boundary_faces(mesh)) {
      const Point area = twice_area(face, rest);
      for (std::size_t k = 0; k < 3; ++k) sum[k] += area[k] / 2;
      for (const Index node : face) volume += dot(rest[at(node)], area) / 18;
    }
    expect_near(sum, {0, 0, 0}, 1e-11);
    EXPECT_NEAR(volume, reference::volume_of(mesh, rest), 1e-11 * volume);
  }
}

TEST(BoundaryFaces, start_with_their_lowest_node_and_ascend) {
  for (const auto& [name, mesh, rest] : reference::mesh_cases()) {
    SCOPED_TRACE(name);
    std::vector<Face> ascending = boundary_faces(mesh);
    for (Face& face : ascending) {
      EXPECT_EQ(face[0], std::ranges::min(face));
      std::ranges::sort(face);
    }
    EXPECT_TRUE(std::ranges::is_sorted(ascending));
    EXPECT_EQ(std::ranges::adjacent_find(ascending), ascending.end());
  }
}

TEST(NodesOnPlane, are_those_of_a_layer_of_a_box) {
  const MeshCase box = reference::box(3, 4, 5, {1e-3, 2e-3, 1e-3}, {0.1, 0, -0.2});
  EXPECT_EQ(nodes_on_plane(box.rest, 0, 0.1, 1e-10).size(), 5u * 6u);
  EXPECT_EQ(nodes_on_plane(box.rest, 1, 8e-3, 1e-10).size(), 4u * 6u);
  const std::vector<Index> bottom = nodes_on_plane(box.rest, 2, -0.2, 1e-10);
  ASSERT_EQ(bottom.size(), 4u * 5u);
  for (Index n = 0; n < 20; ++n) EXPECT_EQ(bottom[at(n)], n);
  EXPECT_TRUE(nodes_on_plane(box.rest, 2, -0.1995, 1e-10).empty());
  EXPECT_TRUE(nodes_on_plane({}, 0, 0, 1).empty());
}

TEST(NodesOnPlane, may_lie_off_it_by_the_tolerance_which_is_a_length) {
  const std::vector<Point> rest{{0, 0, 0}, {0.009, 0, 0}, {0.011, 0, 0}, {-0.009, 5, 10}};
  EXPECT_EQ(nodes_on_plane(rest, 0, 0, 1e-2), (std::vector<Index>{0, 1, 3}));
  EXPECT_EQ(nodes_on_plane(rest, 0, 0, 0), (std::vector<Index>{0}));
  EXPECT_EQ(nodes_on_plane(rest, 0, 0, 1), (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(nodes_on_plane(std::vector<Point>{{0, 0, 0}, {10, 5, 0.009}, {10, 5, 0.011}}, 2, 0, 1e-2),
            (std::vector<Index>{0, 1}));
}

TEST(NodesOnPlane, refuse_an_axis_or_tolerance_that_is_none) {
  const std::vector<Point> rest{{0, 0, 0}};
  EXPECT_THROW(static_cast<void>(nodes_on_plane(rest, 3, 0, 0)), Error);
  EXPECT_THROW(static_cast<void>(nodes_on_plane(rest, -1, 0, 0)), Error);
  EXPECT_THROW(static_cast<void>(nodes_on_plane(rest, 0, 0, -1e-9)), Error);
  EXPECT_THROW(static_cast<void>(nodes_on_plane(rest, 0, 0, std::nan(""))), Error);
  EXPECT_THROW(static_cast<void>(nodes_on_plane(rest, 0, 0, HUGE_VAL)), Error);
}

TEST(PressureLoads, on_a_closed_surface_have_no_resultant_no_torque_and_the_virial_of_the_volume) {
  for (const auto& [name, mesh, rest] : reference::mesh_cases()) {
    SCOPED_TRACE(name);
    const auto forces = pressure_loads(rest, boundary_faces(mesh), 2.5);
    expect_near(sum_of(forces), {0, 0, 0}, 1e-10);
    expect_near(torque_of(forces, rest), {0, 0, 0}, 1e-9);
    double virial = 0, volume = reference::volume_of(mesh, rest);
    for (std::size_t n = 0; n < rest.size(); ++n) virial += dot(forces[n], rest[n]);
    EXPECT_NEAR(virial, -3 * 2.5 * volume, 1e-10 * volume);
  }
}

TEST(PressureLoads, push_one_side_of_a_box_with_pressure_times_area) {
  const MeshCase box = reference::shuffled(reference::box(3, 4, 2, {0.5, 0.25, 1}), 31);
  const auto top = nodes_on_plane(box.rest, 2, 2, 0);
  std::vector<Face> faces;
  for (const Face& face : boundary_faces(box.mesh)) {
    if (std::ranges::all_of(face, [&](Index n) { return std::ranges::binary_search(top, n); })) faces.push_back(face);
  }
  const auto forces = pressure_loads(box.rest, faces, 1000);
  expect_near(sum_of(forces), {0, 0, -1000 * 1.5}, 1e-9);
  for (Index n = 0; n < box.mesh.nodes; ++n) {
    if (!std::ranges::binary_search(top, n)) {
      EXPECT_EQ(forces[at(n)], (Force{0, 0, 0}));
    }
  }
}

TEST(PressureLoads, give_each_corner_a_third) {
  const std::vector<Point> rest{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {9, 9, 9}};
  const auto forces = pressure_loads(rest, std::vector<Face>{{0, 1, 2}}, 0.5);
  for (std::size_t n = 0; n < 3; ++n) expect_near(forces[n], {0, 0, -1}, 1e-15);
  EXPECT_EQ(forces[3], (Force{0, 0, 0}));
}

TEST(PressureLoads, refuse_faces_of_other_nodes) {
  const std::vector<Point> rest(3);
  EXPECT_THROW(static_cast<void>(pressure_loads(rest, std::vector<Face>{{0, 1, 3}}, 1)), Error);
  EXPECT_THROW(static_cast<void>(pressure_loads(rest, std::vector<Face>{{0, -1, 2}}, 1)), Error);
}

TEST(GravityLoads, sum_to_the_weight_at_the_centre_of_mass) {
  const std::array<double, 3> g{0.5, -1, -9.81};
  for (const auto& [name, mesh, rest] : reference::mesh_cases()) {
    SCOPED_TRACE(name);
    const auto forces = gravity_loads(mesh, rest, 1100, g);
    const double mass = 1100 * reference::volume_of(mesh, rest);
    expect_near(sum_of(forces), {mass * g[0], mass * g[1], mass * g[2]}, 1e-12 * mass);
    Point moment{};  // mass times centre
    for (const auto& tet : mesh.tets) {
      for (const Index node : tet) {
        for (std::size_t k = 0; k < 3; ++k) moment[k] += 1100 * six_volumes(tet, rest) / 24 * rest[at(node)][k];
      }
    }
    expect_near(torque_of(forces, rest), cross(moment, g), 1e-10 * mass);
  }
}

TEST(GravityLoads, give_inner_nodes_of_a_box_the_weight_of_a_cell) {
  const MeshCase box = reference::box(2, 2, 2, {0.5, 0.25, 2});
  expect_near(gravity_loads(box.mesh, box.rest, 8, {0, 0, -10})[13], {0, 0, -20}, 1e-12);
}

TEST(GravityLoads, refuse_positions_of_another_number) {
  EXPECT_THROW(static_cast<void>(gravity_loads(make_box_mesh(1, 1, 1), std::vector<Point>(7), 1, {0, 0, 1})), Error);
}

}  // namespace
}  // namespace physgen::fem
