// Numbers that stand twice in a text of Gmsh's format.
#include <fem/mesh/gmsh_text.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "gmsh_format.h"

namespace physgen::fem {
namespace {

using gmsh_format::File, gmsh_format::in_version_1, gmsh_format::in_version_2;

File two_tets() {
  return {{{10, {0, 0, 0}}, {20, {1, 0, 0}}, {30, {0, 1, 0}}, {40, {0, 0, 1}}, {50, {1, 1, 1}}},
          {{7, 4, {10, 20, 30, 40}}, {8, 4, {20, 50, 30, 40}}}};
}

std::string fault_in(const std::string& text) {
  std::istringstream stream(text);
  return fault_in_gmsh_text(stream);
}

// Gmsh reads one of them, and says nothing of the other.
TEST(GmshText, with_two_nodes_or_elements_of_one_number_is_refused_with_both_lines) {
  File nodes = two_tets(), elements = two_tets();
  nodes.nodes[4].first = 20;
  elements.elements[1].tag = 7;
  const std::string remedy = "; give each a number of its own, or write the mesh again";
  const auto said = [&](const std::string& what, int line, int again) {
    return what + " stands in line " + std::to_string(line) + " and, with other values, in line " +
           std::to_string(again) + remedy;
  };
  EXPECT_EQ(fault_in(in_version_2(two_tets())), "");
  EXPECT_EQ(fault_in(in_version_2(nodes)), said("node 20", 7, 10));
  EXPECT_EQ(fault_in(in_version_2(elements)), said("element 7", 14, 15));
  EXPECT_EQ(fault_in(in_version_1(two_tets())), "");
  EXPECT_EQ(fault_in(in_version_1(nodes)), said("node 20", 4, 7));
  EXPECT_EQ(fault_in(in_version_1(elements)), said("element 7", 11, 12));
}

TEST(GmshText, may_have_an_element_once_for_each_of_its_groups) {
  std::string text = in_version_2(two_tets());
  text.replace(text.find("$Elements\n2\n"), 12, "$Elements\n3\n7 4 3 5 6 7 10 20 30 40\n");
  EXPECT_EQ(fault_in(text), "");
}

}  // namespace
}  // namespace physgen::fem
