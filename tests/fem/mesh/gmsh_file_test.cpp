// Meshes from files in Gmsh's format: those of the folder gmsh, which Gmsh wrote, and those of gmsh_format.h.
#include <fem/mesh/check.h>
#include <fem/mesh/gmsh_file.h>
#include <gtest/gtest.h>
#include <physgen/error.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "gmsh_format.h"
#include "mesh_cases.h"

namespace physgen::fem {
namespace {

using gmsh_format::Element, gmsh_format::File, gmsh_format::Tags;
using gmsh_format::in_version_1, gmsh_format::in_version_2, gmsh_format::in_version_4;

// In all versions, and binary ones.
std::vector<std::string> in_all_forms(const File& file) {
  return {in_version_1(file), in_version_2(file), in_version_4(file), gmsh_format::in_binary_version_2(file),
          gmsh_format::in_binary_version_4(file)};
}

// A folder of this test's own, with a blank in its name.
class GmshFile : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / (std::string("gmsh file ") + test->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::filesystem::path write(const std::string& text, const std::string& name = "mesh.msh") const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  // The message of read_gmsh() on a file, after its name; "accepted" if it reads it.
  [[nodiscard]] static std::string refusal(const std::filesystem::path& path) {
    try {
      static_cast<void>(read_gmsh(path));
    } catch (const Error& error) {
      const std::string what = error.what(), start = "physgen: mesh file " + path.string() + ": ";
      return what.starts_with(start) ? what.substr(start.size()) : "the file is not named: " + what;
    }
    return "accepted";
  }

  std::filesystem::path folder_;
};

// A mesh under tags with gaps, in random order.
File file_of(const reference::MeshCase& given, std::uint64_t stream) {
  auto random = reference::random_stream(stream);
  const auto tags = [&random](std::size_t count) {
    Tags all(3 * count + 5);
    std::iota(all.begin(), all.end(), std::size_t{1});
    std::ranges::shuffle(all, random);
    all.resize(count);
    return all;
  };
  File file;
  const Tags node_tags = tags(given.rest.size()), tet_tags = tags(given.mesh.tets.size());
  for (std::size_t n = 0; n < node_tags.size(); ++n) file.nodes.emplace_back(node_tags[n], given.rest[n]);
  for (std::size_t t = 0; t < tet_tags.size(); ++t) {
    Element element{tet_tags[t], 4, {}};
    for (const Index node : given.mesh.tets[t]) element.nodes.push_back(node_tags[static_cast<std::size_t>(node)]);
    file.elements.push_back(element);
  }
  return file;
}

std::string cut_before(const std::string& text, const std::string& mark) { return text.substr(text.find(mark)); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

File one_tet() {
  return {{{10, {0, 0, 0}}, {20, {1, 0, 0}}, {30, {0, 1, 0}}, {40, {0, 0, 1}}}, {{7, 4, {10, 20, 30, 40}}}};
}

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

TEST_F(GmshFile, refuses_a_file_without_tets) {
  File file = one_tet();
  file.elements = {{1, 2, {10, 20, 30}}, {2, 2, {10, 20, 40}}};
  const std::string remedy = "; mesh the volume (gmsh -3), and save it with the elements of the volume";
  EXPECT_EQ(refusal(write(in_version_2(file))), "has no tets, only points, lines or surfaces" + remedy);
  EXPECT_EQ(refusal(write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n")), "has no tets" + remedy);
}

TEST_F(GmshFile, refuses_tets_of_second_order_and_other_solids) {
  File file = one_tet();
  for (std::size_t tag = 41; tag <= 46; ++tag) file.nodes.push_back({tag, {0.1 * static_cast<double>(tag), 0, 0}});
  file.elements = {{1, 11, {10, 20, 30, 40, 41, 42, 43, 44, 45, 46}}};
  EXPECT_EQ(refusal(write(in_version_2(file))),
            "has 1 elements of the kind 'Tetrahedron 10' of order 2; save linear tetrahedra (Gmsh: Mesh.ElementOrder = "
            "1, or -order 1)");
  file.elements = {{1, 4, {10, 20, 30, 40}}, {2, 6, {10, 20, 30, 40, 41, 42}}};
  EXPECT_EQ(refusal(write(in_version_2(file))),
            "has 1 elements of the kind 'Prism 6'; mesh the volume with tetrahedra alone");
}

TEST_F(GmshFile, refuses_a_file_wherever_it_is_cut_off) {
  const File file = file_of(reference::box(2, 2, 2), 63);
  for (const std::string& text : in_all_forms(file)) {
    const std::size_t end = text.find("$E", text.size() - 20);  // of the last section
    const auto expect_refused = [&](std::size_t length) {
      EXPECT_NE(refusal(write(text.substr(0, length))), "accepted")
          << text.substr(0, 20) << " cut off at " << length << " of " << text.size();
    };
    for (std::size_t length = 40; length < end; length += 37) expect_refused(length);
    for (std::size_t length = end - 4; length <= end; ++length) expect_refused(length);  // in the last number
  }
}

TEST_F(GmshFile, refuses_counts_that_are_not_those_of_the_lines_and_names_both) {
  const File file = file_of(reference::box(2, 1, 1), 64);  // 12 nodes, 12 tets
  const std::string again = "; the file may be cut off or damaged: write it again";
  const auto counted = [&](const std::string& section, int start, int said, int lines, int end) {
    return "$" + section + " in line " + std::to_string(start) + " should have " + std::to_string(said) +
           " lines by its counts, but has " + std::to_string(lines) + " before $End" + section + " in line " +
           std::to_string(end) + again;
  };
  const std::string second = in_version_2(file), fourth = in_version_4(file);
  EXPECT_EQ(refusal(write(replaced(second, "$Elements\n12\n", "$Elements\n9\n"))), counted("Elements", 19, 9, 12, 33));
  EXPECT_EQ(refusal(write(replaced(second, "$Elements\n12\n", "$Elements\n13\n"))),
            counted("Elements", 19, 13, 12, 33));
  EXPECT_EQ(refusal(write(replaced(second, "$Nodes\n12\n", "$Nodes\n11\n"))), counted("Nodes", 4, 11, 12, 18));
  EXPECT_EQ(refusal(write(replaced(fourth, "$Elements\n1 12 ", "$Elements\n1 11 "))),
            counted("Elements", 38, 12, 13, 53));
  EXPECT_EQ(refusal(write(replaced(fourth, "$Nodes\n1 12 ", "$Nodes\n1 13 "))), counted("Nodes", 10, 27, 25, 37));
  const std::string first = in_version_1(file);
  EXPECT_NE(refusal(write(replaced(first, "$ELM\n12\n", "$ELM\n9\n"))).find("$ELM in line 16 should have 9 lines"),
            std::string::npos);
  EXPECT_EQ(refusal(write(replaced(second, "$Nodes\n12\n", "$Nodes\n-12\n"))),
            "line 5: $Nodes must begin with the counts of what follows, not with '-12'" + again);
  const std::string beyond = "99999999999999999999";
  EXPECT_EQ(refusal(write(replaced(second, "$Nodes\n12\n", "$Nodes\n" + beyond + "\n"))),
            "line 5: $Nodes must begin with the counts of what follows, not with '" + beyond + "'" + again);
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

TEST_F(GmshFile, refuses_an_element_with_a_node_that_is_not_there_and_names_both) {
  File file = one_tet();
  file.elements[0].nodes[3] = 999;
  const std::string remedy = ", which the file does not have; write the mesh again, with all its nodes";
  for (const std::string& text : in_all_forms(file)) {
    EXPECT_EQ(refusal(write(text)), "element 7 names node 999" + remedy);
  }
  file = one_tet();
  file.elements.push_back({8, 2, {10, 20, 35}});
  for (const std::string& text : in_all_forms(file)) {
    EXPECT_EQ(refusal(write(text)), "element 8 names node 35" + remedy);
  }
}

TEST_F(GmshFile, refuses_versions_that_it_does_not_know_with_the_command_that_saves_another) {
  for (const std::string version : {"9.9", "4", "3"}) {
    EXPECT_EQ(refusal(write("$MeshFormat\n" + version + " 0 8\n$EndMeshFormat\n")),
              "is in version " + version +
                  " of Gmsh's format; save it in version 4.1 (gmsh FILE -save -format msh41 -o FILE.msh)");
  }
  EXPECT_EQ(refusal(write("$Comments\nno version\n$EndComments\n" + cut_before(in_version_2(one_tet()), "$Nodes"))),
            "line 4: $Nodes is not of version 1, as which the file begins; the file may be cut off or damaged: write "
            "it again");
}

TEST_F(GmshFile, refuses_a_binary_file_of_another_order_of_bytes) {
  for (std::string text : {gmsh_format::in_binary_version_2(one_tet()), gmsh_format::in_binary_version_4(one_tet())}) {
    const std::size_t one = text.find("1 8\n") + 4;
    std::reverse(text.begin() + static_cast<std::ptrdiff_t>(one), text.begin() + static_cast<std::ptrdiff_t>(one) + 4);
    EXPECT_EQ(refusal(write(text)),
              "has numbers of another order of bytes; save it on a machine like this one, or as text (Gmsh: "
              "Mesh.Binary = 0)");
  }
}

// Gmsh reads one of them, and says nothing of the other.
TEST_F(GmshFile, with_two_nodes_or_tets_of_one_number_is_refused_with_both_places) {
  File good = one_tet();
  good.nodes.push_back({50, {1, 1, 1}});
  good.elements.push_back({8, 4, {20, 50, 30, 40}});
  File nodes = good, tets = good;
  nodes.nodes[4].first = 20;
  tets.elements[1].tag = 7;
  const std::string remedy = "; give each a number of its own, or write the mesh again";
  const auto said = [&](const std::string& what, int line, int again) {
    return what + " stands in line " + std::to_string(line) + " and, with other values, in line " +
           std::to_string(again) + remedy;
  };
  for (const std::string& text : in_all_forms(good)) EXPECT_EQ(refusal(write(text)), "accepted");
  EXPECT_EQ(refusal(write(in_version_1(nodes))), said("node 20", 4, 7));
  EXPECT_EQ(refusal(write(in_version_1(tets))), said("element 7", 11, 12));
  EXPECT_EQ(refusal(write(in_version_2(nodes))), said("node 20", 7, 10));
  EXPECT_EQ(refusal(write(in_version_2(tets))), said("element 7", 14, 15));
  EXPECT_EQ(refusal(write(in_version_4(nodes))), said("node 20", 14, 17));
  EXPECT_EQ(refusal(write(in_version_4(tets))), said("element 7", 27, 28));
  const std::string bytes = gmsh_format::in_binary_version_4(nodes);
  const std::size_t first = bytes.find("$Nodes\n") + 7 + 4 * 8 + 3 * 4 + 8;
  EXPECT_EQ(refusal(write(bytes)), "node 20 stands at byte " + std::to_string(first + 8) +
                                       " and, with other values, at byte " + std::to_string(first + 32) + remedy);
  tets.elements[1].nodes = tets.elements[0].nodes;  // as of an element in two groups
  for (const std::string& text : in_all_forms(tets)) {
    EXPECT_EQ(read_gmsh(write(text)).tet_tags, Tags{7});
  }
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

// Of some bytes that are changed at random, the reading ends with a mesh or a message.
TEST_F(GmshFile, does_not_fall_over_files_with_changed_bytes) {
  const File file = file_of(reference::box(2, 1, 2), 65);
  auto random = reference::random_stream(66);
  std::size_t refused = 0, count = 0;
  for (const std::string& text : in_all_forms(file)) {
    for (int repeat = 0; repeat < 200; ++repeat) {
      std::string changed = text;
      for (std::size_t k = 1 + random() % 4; k > 0; --k) changed[random() % text.size()] = static_cast<char>(random());
      if (refusal(write(changed)) != "accepted") ++refused;
      ++count;
    }
  }
  EXPECT_GT(refused, count / 4);
  EXPECT_LT(refused, count);
}

// Files of more than 4 GiB that take no room on the disk: counts and offsets are of 64 bits, and memory is taken for
// nothing that the file does not have.
TEST_F(GmshFile, of_many_gigabytes_is_refused_before_memory_is_taken_for_it) {
  std::string text = gmsh_format::in_binary_version_4(one_tet());
  const std::size_t count = text.find("\n$EndElements") - 48;  // of the block
  const auto sized = [&](std::size_t tets, std::uintmax_t bytes) {
    for (const std::size_t place : {count, text.find("$Elements\n") + 18}) {
      std::memcpy(text.data() + place, &tets, sizeof tets);
    }
    const std::filesystem::path path = write(text);
    std::filesystem::resize_file(path, bytes);
    return refusal(path);
  };
  const auto elements = text.size() - count - 8;
  EXPECT_EQ(
      sized(200'000'000, 9'000'000'000),
      "has at least 200000000 tets, more than 32-bit numbers can count; mesh more coarsely, or solve parts of the "
      "body");
  EXPECT_EQ(sized(150'000'000, 5'000'000'000), "byte " + std::to_string(count + 8) +
                                                   ": $Elements has 150000000 rows of 40 bytes from here on by its "
                                                   "counts, and the file ends after " +
                                                   std::to_string(5'000'000'000 - count - 8) +
                                                   " bytes; the file may be cut off or damaged: write it again");
  EXPECT_NE(sized(std::size_t{1} << 61, 5'000'000'000), "accepted");
  EXPECT_GT(elements, 0u);
}

TEST_F(GmshFile, names_the_line_of_what_is_not_a_number) {
  EXPECT_EQ(refusal(write(replaced(in_version_2(one_tet()), "20 1 0 0", "20 1 0,5 0"))),
            "line 7: '0,5' is not a number; the file may be cut off or damaged: write it again");
  EXPECT_EQ(refusal(write(replaced(in_version_2(one_tet()), "20 1 0 0", "20 1 \x1b[2J 0"))),
            "line 7: '?[2J' is not a number; the file may be cut off or damaged: write it again");
}

TEST_F(GmshFile, refuses_what_is_missing_or_no_mesh) {
  const std::string unreadable = "cannot be read; check its name and your rights";
  const std::string format = "is not in Gmsh's mesh format; save the mesh as .msh (gmsh FILE -save -o FILE.msh)";
  EXPECT_EQ(refusal(folder_ / "none.msh"), unreadable);
  EXPECT_EQ(refusal(folder_), unreadable);
  EXPECT_EQ(refusal(write("")), format);
  EXPECT_EQ(refusal(write("Point(1) = {0, 0, 0};\n")), format);
  EXPECT_EQ(refusal(write(in_version_2(one_tet()), "mesh.geo")), format);
}

}  // namespace
}  // namespace physgen::fem
