// Meshes from files in Gmsh's format. Files are written by gmsh_format.h, not by Gmsh.
#include <fem/mesh/check.h>
#include <fem/mesh/gmsh_file.h>
#include <gtest/gtest.h>
#include <omp.h>
#include <physgen/error.h>

#include <algorithm>
#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "gmsh_format.h"
#include "mesh_cases.h"

// The leak sanitizer asks for this by its name: Gmsh keeps what it had read of a file that it then refuses.
extern "C" const char* __lsan_default_suppressions();   // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __lsan_default_suppressions() {  // NOLINT(bugprone-reserved-identifier)
  return "leak:libgmsh";
}

namespace physgen::fem {
namespace {

using gmsh_format::Element, gmsh_format::File, gmsh_format::Tags;
using gmsh_format::in_version_1, gmsh_format::in_version_2, gmsh_format::in_version_4, gmsh_format::in_binary_version_2;

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

File one_tet() {
  return {{{10, {0, 0, 0}}, {20, {1, 0, 0}}, {30, {0, 1, 0}}, {40, {0, 0, 1}}}, {{7, 4, {10, 20, 30, 40}}}};
}

TEST_F(GmshFile, gives_the_nodes_and_tets_of_all_versions_back_with_their_tags_ascending) {
  const File file = file_of(reference::jittered(reference::box(3, 2, 4), 0.1, 61), 62);
  for (const std::string& text :
       {in_version_1(file), in_version_2(file), in_binary_version_2(file), in_version_4(file)}) {
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
  for (const std::string& text :
       {in_version_1(file), in_version_2(file), in_binary_version_2(file), in_version_4(file)}) {
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
  for (const std::string& text :
       {in_version_1(file), in_version_2(file), in_binary_version_2(file), in_version_4(file)}) {
    const std::size_t end = text.find("$E", text.size() - 20);  // of the last section
    const auto expect_refused = [&](std::size_t length) {
      EXPECT_NE(refusal(write(text.substr(0, length))), "accepted")
          << text.substr(0, 20) << " cut off at " << length << " of " << text.size();
    };
    for (std::size_t length = 40; length < end; length += 37) expect_refused(length);
    for (std::size_t length = end - 4; length <= end; ++length) expect_refused(length);  // in the last number
  }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
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

TEST_F(GmshFile, says_what_gmsh_said) {
  File file = one_tet();
  file.elements[0].nodes[3] = 999;
  EXPECT_EQ(refusal(write(in_version_2(file))),
            "Gmsh cannot read it (Wrong node index 999); the file may be cut off or damaged: write it again");
  EXPECT_EQ(refusal(write("$MeshFormat\n9.9 0 8\n$EndMeshFormat\n")),
            "Gmsh cannot read it (Unknown MSH file version 9.9); the file may be cut off or damaged: write it again");
}

TEST_F(GmshFile, names_the_line_of_what_is_not_a_number) {
  EXPECT_EQ(refusal(write(replaced(in_version_2(one_tet()), "20 1 0 0", "20 1 0,5 0"))),
            "line 7: '0,5' is not a number; the file may be cut off or damaged: write it again");
  EXPECT_EQ(refusal(write(replaced(in_version_2(one_tet()), "20 1 0 0", "20 1 \x1b[2J 0"))),
            "line 7: '?[2J' is not a number; the file may be cut off or damaged: write it again");
}

TEST_F(GmshFile, refuses_what_is_missing_or_no_mesh_and_runs_no_script) {
  const std::string unreadable = "cannot be read; check its name and your rights";
  const std::string format = "is not in Gmsh's mesh format; save the mesh as .msh (gmsh FILE -save -o FILE.msh)";
  EXPECT_EQ(refusal(folder_ / "none.msh"), unreadable);
  EXPECT_EQ(refusal(folder_), unreadable);
  EXPECT_EQ(refusal(write("")), format);
  const std::filesystem::path mark = folder_ / "mark";
  const std::string script = "Point(1) = {0, 0, 0};\nSystemCall \"touch '" + mark.string() + "'\";\n";
  EXPECT_EQ(refusal(write(script)), format);
  EXPECT_EQ(refusal(write(in_version_2(one_tet()), "mesh.geo")), format);
  static_cast<void>(write(script, "mesh.msh.opt"));
  EXPECT_EQ(refusal(write(in_version_2(one_tet()))), "accepted");
  EXPECT_FALSE(std::filesystem::exists(mark));
}

// A folder would stay where a kill ends the process.
TEST_F(GmshFile, is_read_without_a_temporary_folder) {
  const std::filesystem::path path = write(in_version_2(one_tet()));
  const char* kept = std::getenv("TMPDIR");
  const std::string before = kept == nullptr ? "" : kept;
  ASSERT_EQ(setenv("TMPDIR", (folder_ / "none").c_str(), 1), 0);
  EXPECT_EQ(refusal(path), "accepted");
  ASSERT_EQ(kept == nullptr ? unsetenv("TMPDIR") : setenv("TMPDIR", before.c_str(), 1), 0);
}

TEST_F(GmshFile, prints_nothing_and_leaves_threads_and_locale_as_they_were) {
  const std::filesystem::path good = write(in_version_2(one_tet())), bad = write("$MeshFormat\n9.9 0 8\n", "bad.msh");
  omp_set_num_threads(3);
  const std::string locale = std::setlocale(LC_ALL, nullptr);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const std::string said = refusal(good), refused = refusal(bad);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(said, "accepted");
  EXPECT_NE(refused, "accepted");
  EXPECT_EQ(omp_get_max_threads(), 3);
  EXPECT_EQ(std::setlocale(LC_ALL, nullptr), locale);
}

TEST_F(GmshFile, may_be_read_again_and_again) {
  const std::filesystem::path path = write(in_version_4(one_tet()));
  for (int repeat = 0; repeat < 3; ++repeat) EXPECT_EQ(read_gmsh(path).tet_tags, Tags{7});
}

}  // namespace
}  // namespace physgen::fem
