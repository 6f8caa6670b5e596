// Schemas of one file name in several folders: the headers that are generated of them would have one name, too.
#include <gtest/gtest.h>

#include "case.h"

namespace physgen::test {
namespace {

std::string schema_in(const std::string& scope, const std::string& objects) {
  return "#pragma once\n#include <physgen/schema.h>\nnamespace " + scope + " {\nusing namespace physgen::schema;\n" +
         objects + "}\n";
}
const std::string two_objects = object("Scalar x;") + "struct PHYSGEN_OBJECT() B {\n  Scalar x;\n};\n";

TEST(FileNames, of_two_included_schemas_are_different) {
  const Folder folder;
  folder.write("x/shape.h", schema_in("x", two_objects));
  folder.write("y/shape.hpp", schema_in("y", two_objects));
  const auto main = folder.write(
      "main.h", "#include \"x/shape.h\"\n#include \"y/shape.hpp\"\n" + schema_of(object("x::A a; y::A b; y::B c;")));
  const auto result = parse_file(main);
  EXPECT_FALSE(result.schema.has_value());
  EXPECT_NE(result.diagnostics.find("y/shape.hpp:5:25: error: object 'A' is declared in '"), std::string::npos)
      << result.diagnostics;
  EXPECT_NE(result.diagnostics.find("1 error generated"), std::string::npos) << "each file is named once";
  EXPECT_NE(result.diagnostics.find("y/shape.hpp' and others in '"), std::string::npos) << result.diagnostics;
  EXPECT_NE(result.diagnostics.find("x/shape.h', and the headers that are generated of the two have one name; rename "
                                    "one file"),
            std::string::npos)
      << result.diagnostics;
}

TEST(FileNames, of_a_schema_and_one_that_it_includes_are_different) {
  const Folder folder;
  folder.write("x/shape.h", schema_in("x", two_objects));
  const auto main = folder.write("shape.h", "#include \"x/shape.h\"\n" + schema_of(object("x::A a;")));
  const auto result = parse_file(main);
  EXPECT_FALSE(result.schema.has_value());
  EXPECT_NE(result.diagnostics.find("/shape.h:4:25: error: object 'A' is declared in '"), std::string::npos)
      << result.diagnostics;
}

TEST(FileNames, are_those_of_one_file_by_whatever_path_it_is_included) {
  const Folder folder;
  folder.write("x/shape.h", schema_in("x", two_objects));
  folder.write("y/part.h", "#include \"../x/shape.h\"\n" + schema_in("y", object("x::A a;")));
  const auto main =
      folder.write("main.h", "#include \"x/shape.h\"\n#include \"y/part.h\"\n#include \"y/../x/shape.h\"\n" +
                                 schema_of(object("x::A a; y::A b;")));
  const auto result = parse_file(main);
  EXPECT_TRUE(result.schema.has_value()) << result.diagnostics;
}

}  // namespace
}  // namespace physgen::test
