// Meshes from files in Gmsh's format: those of the folder gmsh, which Gmsh wrote, and those of gmsh_format.h.
#include <fem/mesh/check.h>
#include <physgen/threads.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "gmsh_fixture.h"

namespace physgen::fem {
namespace {

TEST_F(GmshFile, gives_the_nodes_and_tets_of_all_versions_back_with_their_tags_ascending) {
  const File file = file_of(reference::jittered(reference::box(3, 2, 4), 0.1, 61), 62);
  for (const std::string& text : in_all_forms(file)) {
    SCOPED_TRACE(text.substr(0, 20));
    const ReadMesh mesh = read_gmsh(write(text));
    ASSERT_EQ(mesh.node_tags.size(), file.nodes.size());
    ASSERT_EQ(mesh.rest.size(), file.nodes.size());
    ASSERT_EQ(mesh.tet_tags.size(), file.elements.size());
    ASSERT_EQ(mesh.tets.size(), file.elements.size());
    EXPECT_TRUE(std::ranges::is_sorted(mesh.node_tags));
    EXPECT_TRUE(std::ranges::is_sorted(mesh.tet_tags));
    EXPECT_TRUE(mesh.left_out_nodes.empty());
    for (const auto& [tag, x] : file.nodes) {
      const auto n = std::ranges::lower_bound(mesh.node_tags, tag) - mesh.node_tags.begin();
      EXPECT_EQ(mesh.rest[static_cast<std::size_t>(n)], x);
    }
    for (const Element& element : file.elements) {
      const auto t = std::ranges::lower_bound(mesh.tet_tags, element.tag) - mesh.tet_tags.begin();
      for (std::size_t c = 0; c < 4; ++c) {
        const Index node = mesh.tets[static_cast<std::size_t>(t)][c];
        EXPECT_EQ(mesh.node_tags[static_cast<std::size_t>(node)], element.nodes[c]);
      }
    }
    EXPECT_TRUE(check_mesh(mesh.rest, mesh.tets).errors().empty());
  }
}

TEST_F(GmshFile, leaves_out_and_lists_nodes_that_only_surfaces_and_points_use) {
  File file = one_tet();
  file.nodes.insert(file.nodes.begin(), {{15, {5, 5, 5}}, {99, {6, 5, 5}}, {3, {5, 6, 5}}});
  file.elements.push_back({8, 2, {15, 99, 10}});
  file.elements.push_back({9, 15, {3}});
  for (const std::string& text : in_all_forms(file)) {
    const ReadMesh mesh = read_gmsh(write(text));
    EXPECT_EQ(mesh.left_out_nodes, (Tags{3, 15, 99}));
    EXPECT_EQ(mesh.node_tags, (Tags{10, 20, 30, 40}));
    EXPECT_EQ(mesh.tet_tags, Tags{7});
    EXPECT_EQ(mesh.tets, (std::vector<std::array<Index, 4>>{{0, 1, 2, 3}}));
  }
}

TEST_F(GmshFile, keeps_nodes_of_no_element_for_the_check_to_tell_of) {
  File file = one_tet();
  file.nodes.push_back({77, {5, 5, 5}});
  const ReadMesh mesh = read_gmsh(write(in_version_4(file)));
  EXPECT_EQ(mesh.node_tags, (Tags{10, 20, 30, 40, 77}));
  EXPECT_EQ(check_mesh(mesh.rest, mesh.tets).errors(mesh.node_tags, mesh.tet_tags),
            std::vector<std::string>{"1 node of no element (node 77); remove what no element uses (in Gmsh: save the "
                                     "volumes alone)"});
}

TEST_F(GmshFile, keeps_inverted_tets_as_they_are) {
  File file = one_tet();
  std::swap(file.elements[0].nodes[0], file.elements[0].nodes[1]);
  const ReadMesh mesh = read_gmsh(write(in_version_2(file)));
  EXPECT_EQ(mesh.tets[0], (std::array<Index, 4>{1, 0, 2, 3}));
}

TEST_F(GmshFile, reads_texts_with_tabs_carriage_returns_and_sections_of_others) {
  const std::string text = in_version_2(one_tet());
  std::string other = replaced(text, "$Elements\n1\n", "$Comments\nof others\n$EndComments\n$Elements\n 1 \n");
  EXPECT_EQ(refusal(write(other)), "accepted");
  for (std::size_t at = 0; (at = other.find('\n', at)) != std::string::npos; at += 2) other.replace(at, 1, "\r\n");
  EXPECT_EQ(refusal(write(other)), "accepted");
  EXPECT_EQ(refusal(write(replaced(text, "10 0 0 0", "10\t0\t+0\t0 "))), "accepted");
  EXPECT_EQ(refusal(write(text.substr(0, text.size() - 1))), "accepted");
}

TEST_F(GmshFile, may_number_nodes_and_tets_anyhow) {
  File file = one_tet();
  const std::size_t most = std::numeric_limits<std::size_t>::max();
  for (auto& node : file.nodes) node.first = most - 7 * node.first * node.first * (node.first % 3 == 1 ? most / 4 : 1);
  for (std::size_t c = 0; c < 4; ++c) file.elements[0].nodes[c] = file.nodes[c].first;
  file.elements[0].tag = most;
  Tags tags = file.elements[0].nodes;
  std::ranges::sort(tags);
  for (const std::string& text :
       {in_version_1(file), in_version_2(file), in_version_4(file), gmsh_format::in_binary_version_4(file)}) {
    const ReadMesh mesh = read_gmsh(write(text));
    EXPECT_EQ(mesh.node_tags, tags);
    EXPECT_EQ(mesh.tet_tags, Tags{most});
    for (std::size_t c = 0; c < 4; ++c) {
      EXPECT_EQ(mesh.node_tags[static_cast<std::size_t>(mesh.tets[0][c])], file.elements[0].nodes[c]);
    }
  }
  EXPECT_EQ(refusal(write(replaced(in_version_2(one_tet()), "20 1 0 0", "-20 1 0 0"))),
            "line 7: '-20' is not a natural number; the file may be cut off or damaged: write it again");
}

// Blocks of many tets are read on several threads, those of one tet one after the other.
TEST_F(GmshFile, says_the_same_in_binary_blocks_of_any_size_on_any_number_of_threads) {
  File file = file_of(reference::jittered(reference::box(14, 15, 16), 0.1, 63), 64);
  for (const std::size_t e : {std::size_t{0}, std::size_t{9000}}) {  // triangles between blocks of tets
    const Tags& nodes = file.elements[e].nodes;
    file.elements.insert(file.elements.begin() + static_cast<std::ptrdiff_t>(e),
                         Element{100000000 + e, 2, {nodes[0], nodes[1], nodes[2]}});
  }
  const ReadMesh one_by_one = read_gmsh(write(in_version_4(file)));
  ASSERT_EQ(one_by_one.tets.size(), 14u * 15 * 16 * 6);
  for (const std::size_t most : {std::size_t{1}, std::size_t{7}, std::size_t{1000000}}) {
    const std::filesystem::path path = write(gmsh_format::in_binary_version_4(file, most));
    for (const int count : {1, 2, 16}) {
      SCOPED_TRACE(std::to_string(most) + " in a block, " + std::to_string(count) + " threads");
      set_threads(count);
      const ReadMesh mesh = read_gmsh(path);
      EXPECT_EQ(mesh.rest, one_by_one.rest);
      EXPECT_EQ(mesh.tets, one_by_one.tets);
      EXPECT_EQ(mesh.node_tags, one_by_one.node_tags);
      EXPECT_EQ(mesh.tet_tags, one_by_one.tet_tags);
    }
  }
  set_threads(0);
  // A block of many whose last tet the file does not have.
  const std::string text = gmsh_format::in_binary_version_4(file, 1000000);
  EXPECT_TRUE(refusal(write(text.substr(0, text.find("\n$EndElements") - 8))).find("the file ends after") !=
              std::string::npos);
}

// What Gmsh wrote of one geometry says the same in all forms. Elements of points, lines and surfaces stand in it, too.
TEST_F(GmshFile, reads_what_gmsh_wrote_in_any_form) {
  const std::filesystem::path folder = PHYSGEN_GMSH_FOLDER;
  const ReadMesh mesh = read_gmsh(folder / "text_41.msh");
  EXPECT_EQ(mesh.rest.size(), 23u);
  EXPECT_EQ(mesh.tets.size(), 48u);
  EXPECT_EQ(mesh.left_out_nodes, Tags{13});
  double volume = 0;
  for (const auto& tet : mesh.tets) volume += six_volumes(tet, mesh.rest) / 6;
  EXPECT_NEAR(volume, 2, 1e-14);
  EXPECT_TRUE(check_mesh(mesh.rest, mesh.tets).errors().empty());
  EXPECT_EQ(check_mesh(mesh.rest, mesh.tets).component_count, 1u);
  for (const char* form : {"binary_41.msh", "text_22.msh", "binary_22.msh"}) {
    SCOPED_TRACE(form);
    const ReadMesh other = read_gmsh(folder / form);
    ASSERT_EQ(other.rest.size(), mesh.rest.size());
    for (std::size_t n = 0; n < mesh.rest.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(other.rest[n][k], mesh.rest[n][k], 1e-15);  // 16 digits of text
    }
    EXPECT_EQ(other.tets, mesh.tets);
    EXPECT_EQ(other.node_tags, mesh.node_tags);
    EXPECT_EQ(other.tet_tags, mesh.tet_tags);
    EXPECT_EQ(other.left_out_nodes, mesh.left_out_nodes);
  }
}

}  // namespace
}  // namespace physgen::fem
