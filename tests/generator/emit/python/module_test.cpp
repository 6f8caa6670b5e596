// The text of sources of Python modules, and what is refused of them, from models built by hand.
#include "emit/python/module.h"

#include <gtest/gtest.h>

#include "models.h"
#include "text_checks.h"

namespace physgen::emit::python {
namespace {

using test::expect_contains;
using test::object;
using test::scalar;
using test::schema;

std::string messages(const model::Schema& made) {
  std::string text;
  for (const model::Issue& issue : objections(made)) text += issue.message + "\n";
  return text;
}

TEST(PythonModule, has_a_class_of_each_object_and_no_imported_one) {
  auto padded = object("A", {scalar("x")}, "a::b");
  padded.host_layout = model::Layout{model::LayoutKind::aos_padded, 0};
  auto all = schema({padded, object("B", {scalar("y")}, "c")});
  all.imported = {object("P", {scalar("x")}, "other")};
  const std::string text = module_source(all);
  expect_contains(
      text, "#include <physgen/python/module.h>\n\n#include \"test.physgen.h\"\n\nPYBIND11_MODULE(test, module) {\n");
  expect_contains(text, "add_class<a::b::AObject, physgen::AosPadded, physgen::Aosoa<32>>(\n      module, \"A\",\n");
  expect_contains(text, "add_class<c::BObject, physgen::Aosoa<16>, physgen::Aosoa<32>>(\n      module, \"B\",\n");
  EXPECT_EQ(text.find("PObject"), std::string::npos);
}

TEST(PythonModule, keeps_comments_of_any_letters_as_documentation) {
  auto sly = scalar("x");
  sly.unit = "\\\"";
  sly.doc = "first \\\nsecond \"quoted\" ?\?/";
  sly.array_extent = 3;
  const std::string text = module_source(schema({object("A", {sly})}));
  expect_contains(text, "      \"x : Scalar[3] [\\\\\\\"]\\n\"\n");
  expect_contains(text, "      \"    first \\\\\\n\"\n");
  expect_contains(text, "      \"    second \\\"quoted\\\" \\?\\?/\\n\");\n");
}

TEST(PythonModule, refuses_file_names_that_python_cannot_import) {
  auto made = schema({object("A", {scalar("x")})});
  EXPECT_EQ(messages(made), "");
  for (const char* name : {"tissue-model", "tissue.model", "2d", "lambda"}) {
    made.file = std::string(name) + ".h";
    EXPECT_EQ(messages(made), "the Python module of this schema would be called '" + std::string(name) +
                                  "', which is no name in Python; rename the file '" + made.file + "'\n");
  }
}

TEST(PythonModule, refuses_two_classes_of_one_name_and_what_accessor_classes_cannot_be_made_of) {
  EXPECT_EQ(
      messages(schema({object("A", {scalar("x")}, "a"), object("A", {scalar("x")}, "b")})),
      "a second object is called 'A'; classes of a Python module stand in no namespaces, so rename one of them\n");
  expect_contains(messages(schema({object("A", {scalar("xor")})})), "'xor'");
}

}  // namespace
}  // namespace physgen::emit::python
