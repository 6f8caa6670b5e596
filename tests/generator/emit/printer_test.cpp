// Lines of generated text: how they are broken.
#include "emit/printer.h"

#include <gtest/gtest.h>

namespace physgen::emit {
namespace {

TEST(Printer, wraps_comments_and_keeps_their_lines) {
  Printer out;
  out.open("{");
  out.comment("///", "short\n\n  indented " + std::string(115, 'x'));
  out.close("}");
  EXPECT_EQ(std::move(out).text(), "{\n  /// short\n  ///\n  ///   indented\n  /// " + std::string(115, 'x') + "\n}\n");
}

TEST(Printer, wraps_the_rest_of_a_paragraph_with_a_long_line) {
  const std::string words = "x" + std::string(80, 'x'), tail = std::string(50, 'y');
  Printer out;
  out.comment("//", words + " " + tail + "\n(goes on)\n@pre is kept");
  EXPECT_EQ(std::move(out).text(), "// " + words + "\n// " + tail + " (goes on)\n// @pre is kept\n");
}

TEST(Printer, fills_further_lines_with_what_does_not_fit_on_the_first) {
  const std::vector<std::string> items(5, std::string(40, 'x'));
  Printer out;
  out.filled("call(", {"a", "b"}, ");");
  out.filled("call(", items, ");");
  const std::string& item = items.front();
  EXPECT_EQ(std::move(out).text(), "call(a, b);\ncall(\n    " + item + ", " + item + ",\n    " + item + ", " + item +
                                       ",\n    " + item + ");\n");
}

TEST(Printer, fills_lines_with_members_without_commas) {
  const std::string member = "int " + std::string(70, 'x') + ";";
  Printer out;
  out.filled("struct a { ", {"int x;", "int y;"}, " };", "");
  out.filled("struct b { ", {"int x;", "int y;", member, member}, " };", "");
  EXPECT_EQ(std::move(out).text(),
            "struct a { int x; int y; };\nstruct b {\n    int x; int y; " + member + "\n    " + member + " };\n");
}

TEST(Printer, fills_with_an_item_that_is_too_long_for_any_line) {
  Printer out;
  out.filled("call(", {std::string(130, 'x'), "y"}, ");");
  EXPECT_EQ(std::move(out).text(), "call(\n    " + std::string(130, 'x') + ",\n    y);\n");
}

TEST(Printer, aligns_the_terms_of_a_sum_behind_its_head) {
  const std::string term(40, 'x');
  Printer out;
  out.list("return ", {term, term, term, term}, ";", " +");
  EXPECT_EQ(std::move(out).text(), "return " + term + " + " + term + " +\n       " + term + " + " + term + ";\n");
}

}  // namespace
}  // namespace physgen::emit
