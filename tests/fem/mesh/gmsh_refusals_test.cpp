// Files that are damaged, or are no mesh of linear tets: what is said of them.

#include <cstring>
#include <filesystem>
#include <string>

#include "gmsh_fixture.h"

namespace physgen::fem {
namespace {

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
  const auto other = write("*NODE\n1, 0, 0, 0\n", "body.inp");
  EXPECT_EQ(refusal(other), "is not in Gmsh's mesh format; convert it with its groups: physgen-convert-mesh '" +
                                other.string() + "' '" + (folder_ / "body.msh").string() +
                                "' (in a checkout tools/fem/mesh/convert.py)");
  const std::string said = refusal(write("*NODE\n1, 0, 0, 0\n", "my 'body.INP"));
  EXPECT_NE(said.find("/my '\\''body.INP' '"), std::string::npos) << said;
  EXPECT_NE(said.find("/my '\\''body.msh' (in"), std::string::npos) << said;
}

}  // namespace
}  // namespace physgen::fem
