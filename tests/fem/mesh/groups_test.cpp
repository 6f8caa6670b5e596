// Groups that a mesh names: those of the folder gmsh, which Gmsh wrote, and their refinement.
#include <fem/mesh/check.h>
#include <fem/mesh/groups.h>
#include <fem/mesh/refine.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "gmsh_fixture.h"

namespace physgen::fem {
namespace {

using Groups = GmshFile;

const std::vector<std::string> forms{"text_22.msh", "text_41.msh", "binary_22.msh", "binary_41.msh"};

ReadMesh two_boxes(const std::string& form) { return read_gmsh(std::filesystem::path(PHYSGEN_GMSH_FOLDER) / form); }

// The nodes of a mesh that a predicate holds for, ascending.
std::vector<Index> nodes_where(const std::vector<Point>& rest, const std::function<bool(const Point&)>& holds) {
  std::vector<Index> nodes;
  for (std::size_t n = 0; n < rest.size(); ++n) {
    if (holds(rest[n])) nodes.push_back(static_cast<Index>(n));
  }
  return nodes;
}

bool is_between(const Point& x) { return std::abs(x[2] - 1) < 1e-12; }
bool is_on_edge(const Point& x) { return std::abs(x[1]) < 1e-12 && std::abs(x[2]) < 1e-12; }

double area_of(const std::vector<Point>& rest, const std::vector<Face>& faces) {
  double sum = 0;
  for (const double area : surface_areas(rest, faces)) sum += area;
  return sum;
}

TEST_F(Groups, of_files_that_gmsh_wrote_have_the_nodes_lines_faces_and_tets_of_their_places) {
  for (const std::string& form : forms) {
    SCOPED_TRACE(form);
    const ReadMesh mesh = two_boxes(form);
    ASSERT_EQ(mesh.groups.size(), 5U);
    const MeshGroup& between = group_named(mesh.groups, "between");
    EXPECT_EQ(between.nodes, nodes_where(mesh.rest, is_between));
    EXPECT_GT(between.faces.size(), 1U);
    EXPECT_NEAR(area_of(mesh.rest, between.faces), 1, 1e-12);
    EXPECT_TRUE(between.tets.empty());
    const MeshGroup& edge = group_named(mesh.groups, "edge");
    EXPECT_EQ(edge.nodes, nodes_where(mesh.rest, is_on_edge));
    EXPECT_EQ(edge.lines.size() + 1, edge.nodes.size());
    // The point apart is of no tet.
    EXPECT_TRUE(group_named(mesh.groups, "apart").nodes.empty());
    const MeshGroup &lower = group_named(mesh.groups, "lower"), &upper = group_named(mesh.groups, "upper");
    EXPECT_EQ(lower.tets.size() + upper.tets.size(), mesh.tets.size());
    EXPECT_EQ(lower.nodes, nodes_where(mesh.rest, [](const Point& x) { return x[2] < 1 + 1e-12; }));
    EXPECT_EQ(upper.nodes, nodes_where(mesh.rest, [](const Point& x) { return x[2] > 1 - 1e-12; }));
  }
}

TEST_F(Groups, that_a_mesh_lacks_are_refused_with_the_nearest_and_all_names) {
  const ReadMesh mesh = two_boxes("text_41.msh");
  const auto refusal_of = [](std::span<const MeshGroup> groups, const std::string& name) -> std::string {
    try {
      static_cast<void>(group_named(groups, name));
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(refusal_of(mesh.groups, "loer"),
            "physgen: the mesh has no group 'loer'; did you mean 'lower'? It has apart, edge, between, lower, upper");
  EXPECT_EQ(refusal_of(mesh.groups, "xyzzy"),
            "physgen: the mesh has no group 'xyzzy'; it has apart, edge, between, lower, upper");
  EXPECT_EQ(
      refusal_of({}, "base"),
      "physgen: the mesh has no group 'base'; it has none at all: name physical groups in Gmsh, and save the mesh "
      "again");
}

TEST_F(Groups, of_one_name_in_several_dimensions_are_one_and_elements_that_stand_there_twice_are_one) {
  File file = one_tet();
  file.elements.push_back({8, 2, {10, 20, 30}});
  std::string text = in_version_2(file);
  text = replaced(text, "$Nodes", "$PhysicalNames\n2\n2 4 \"all of it\"\n3 5 \"all of it\"\n$EndPhysicalNames\n$Nodes");
  text = replaced(text, "7 4 2 0 1", "7 4 2 5 1");
  text = replaced(text, "8 2 2 0 1", "8 2 2 4 1");
  text = replaced(text, "$Elements\n2\n", "$Elements\n3\n8 2 2 4 2 10 20 30\n");
  const ReadMesh mesh = read_gmsh(write(text));
  ASSERT_EQ(mesh.groups.size(), 1U);
  EXPECT_EQ(mesh.groups[0], (MeshGroup{"all of it", {0, 1, 2, 3}, {}, {{0, 1, 2}}, {0}}));
}

TEST_F(Groups, with_names_that_are_none_are_refused_with_their_line) {
  const auto with_names = [](const std::string& rows) {
    return replaced(in_version_2(one_tet()), "$Nodes", "$PhysicalNames\n" + rows + "$EndPhysicalNames\n$Nodes");
  };
  EXPECT_TRUE(refusal(write(with_names("1\n2 x \"top\"\n"))).starts_with("line 6: a row of $PhysicalNames is"));
  EXPECT_TRUE(refusal(write(with_names("1\n2 7 top\n"))).starts_with("line 6: a row of $PhysicalNames is"));
  EXPECT_TRUE(refusal(write(with_names("2\n2 7 \"top\"\n"))).starts_with("line 7: $PhysicalNames has fewer rows"));
  EXPECT_TRUE(
      refusal(write(with_names("0\n2 7 \"top\"\n"))).starts_with("$PhysicalNames in line 4 should have 0 lines"));
  EXPECT_TRUE(refusal(write(with_names("many\n"))).starts_with("line 5: $PhysicalNames must begin with"));
}

TEST_F(Groups, refine_with_their_mesh) {
  ReadMesh read = two_boxes("binary_41.msh");
  std::vector<MeshGroup> groups = read.groups;
  std::vector<Point> rest = read.rest;
  TetMesh mesh = make_tet_mesh(static_cast<Index>(rest.size()), read.tets);
  for (int k = 0; k < 2; ++k) {
    groups = refine_groups(mesh, groups);
    Refined refined = refine(mesh, rest);
    mesh = std::move(refined.mesh);
    rest = std::move(refined.rest);
  }
  const MeshGroup& between = group_named(groups, "between");
  EXPECT_EQ(between.nodes, nodes_where(rest, is_between));
  EXPECT_EQ(between.faces.size(), 16 * group_named(read.groups, "between").faces.size());
  EXPECT_NEAR(area_of(rest, between.faces), 1, 1e-12);
  const MeshGroup& edge = group_named(groups, "edge");
  EXPECT_EQ(edge.nodes, nodes_where(rest, is_on_edge));
  EXPECT_EQ(edge.lines.size() + 1, edge.nodes.size());
  const MeshGroup &lower = group_named(groups, "lower"), &upper = group_named(groups, "upper");
  EXPECT_EQ(lower.nodes, nodes_where(rest, [](const Point& x) { return x[2] < 1 + 1e-12; }));
  std::vector<Index> all = lower.tets;
  all.insert(all.end(), upper.tets.begin(), upper.tets.end());
  std::ranges::sort(all);
  EXPECT_EQ(all.size(), mesh.tets.size());
  EXPECT_EQ(std::ranges::adjacent_find(all), all.end());
}

TEST_F(Groups, of_faces_are_turned_outward_and_refused_inside_a_body) {
  const ReadMesh read = two_boxes("text_22.msh");
  const TetMesh mesh = make_tet_mesh(static_cast<Index>(read.rest.size()), read.tets);
  MeshGroup top{"top", {}, {}, {}, {}};
  const std::vector<Face> surface = boundary_faces(mesh);
  for (const auto& [a, b, c] : surface) {
    const auto z = [&](Index n) { return read.rest[static_cast<std::size_t>(n)][2]; };
    if (z(a) > 2 - 1e-12 && z(b) > 2 - 1e-12 && z(c) > 2 - 1e-12) top.faces.push_back({a, c, b});  // inward
  }
  complete(top, {});
  double up = 0;
  for (const Force& force : pressure_loads(read.rest, outward_faces(mesh, read.rest, top), -1.0)) up += force[2];
  EXPECT_NEAR(up, 1, 1e-12);  // [N], of 1 Pa over 1 m^2
  try {
    static_cast<void>(outward_faces(mesh, read.rest, group_named(read.groups, "between")));
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("group 'between': its face with corners at ("), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace physgen::fem
