// Models that the frontend reads from sound schemas, and the look of its diagnostics.
#include <gtest/gtest.h>

#include <iterator>

#include "case.h"

namespace physgen::test {
namespace {

using model::Element;
using model::Shape;

/// The schema's model; the test fails if it has errors.
model::Schema sound(const std::string& text) {
  auto result = parse_text(schema_of(text));
  EXPECT_TRUE(result.schema.has_value()) << result.diagnostics;
  EXPECT_EQ(result.diagnostics, "");
  return result.schema.value_or(model::Schema{});
}

struct TypeCase {
  const char* members;
  Shape shape;
  Element element;
  int rows, cols, elements;
};

TEST(Frontend, reads_every_type_of_the_vocabulary) {
  const TypeCase cases[] = {
      {"Scalar a;", Shape::scalar, Element::real, 1, 1, 1},
      {"Index a;", Shape::scalar, Element::index, 1, 1, 1},
      {"float a;", Shape::scalar, Element::float32, 1, 1, 1},
      {"double a;", Shape::scalar, Element::float64, 1, 1, 1},
      {"int a;", Shape::scalar, Element::int32, 1, 1, 1},
      {"Vector<4> a;", Shape::vector, Element::real, 4, 1, 4},
      {"Vector<4, Index> a;", Shape::vector, Element::index, 4, 1, 4},
      {"Matrix<3, 2> a;", Shape::matrix, Element::real, 3, 2, 6},
      {"Matrix<3, 2, double> a;", Shape::matrix, Element::float64, 3, 2, 6},
      {"Symmetric<3> a;", Shape::symmetric, Element::real, 3, 3, 6},
      {"Symmetric<6, float> a;", Shape::symmetric, Element::float32, 6, 6, 21},
      {"Diagonal<3> a;", Shape::diagonal, Element::real, 3, 3, 3},
      {"Skew<3> a;", Shape::skew, Element::real, 3, 3, 3},
      {"Rotation a;", Shape::rotation, Element::real, 3, 3, 9},
  };
  for (const TypeCase& expected : cases) {
    const auto schema = sound(object(expected.members));
    ASSERT_EQ(schema.objects.size(), 1u);
    const auto& field = schema.objects[0].fields.at(0);
    EXPECT_EQ(field.shape, expected.shape) << expected.members;
    EXPECT_EQ(field.element, expected.element) << expected.members;
    EXPECT_EQ(field.rows, expected.rows) << expected.members;
    EXPECT_EQ(field.cols, expected.cols) << expected.members;
    EXPECT_EQ(model::element_count(field), expected.elements) << expected.members;
  }
}

TEST(Frontend, reads_aliases_constants_and_arrays) {
  const auto schema = sound("constexpr int corners = 4;\nusing Block = Symmetric<corners - 1>;\n" +
                            object("Block k[corners]; Scalar x[1];"));
  const auto& fields = schema.objects.at(0).fields;
  EXPECT_EQ(fields.at(0).shape, Shape::symmetric);
  EXPECT_EQ(fields.at(0).rows, 3);
  EXPECT_EQ(fields.at(0).array_extent, 4);
  EXPECT_EQ(fields.at(1).array_extent, 1);
}

TEST(Frontend, reads_options_of_objects_and_fields) {
  const auto schema = sound(
      "struct PHYSGEN_OBJECT(layout(host, aosoa(16)), layout(cuda, aos_padded), align(64)) A {\n"
      "  PHYSGEN(unit(\"N/m^2\"), range(-1, 1e9), initial(0.5)) Vector<3> x, y;\n  Scalar z;\n};\n"
      "struct PHYSGEN_OBJECT(layout(host, soa)) B {\n  Scalar x;\n};\n");
  const auto& a = schema.objects.at(0);
  EXPECT_EQ(a.host_layout, (model::Layout{model::LayoutKind::aosoa, 16}));
  EXPECT_EQ(a.cuda_layout, (model::Layout{model::LayoutKind::aos_padded, 0}));
  EXPECT_EQ(a.alignment, 64);
  for (const int i : {0, 1}) {
    const auto& field = a.fields.at(static_cast<std::size_t>(i));
    EXPECT_EQ(field.unit, "N/m^2");
    EXPECT_EQ(field.range, (model::Range{-1, 1e9}));
    EXPECT_EQ(field.initial, 0.5);
  }
  EXPECT_EQ(a.fields.at(2).unit, "");
  EXPECT_FALSE(a.fields.at(2).initial.has_value());
  EXPECT_EQ(schema.objects.at(1).host_layout, (model::Layout{model::LayoutKind::soa, 0}));
  EXPECT_FALSE(schema.objects.at(1).cuda_layout.has_value());
}

TEST(Frontend, reads_formats_per_memory_space) {
  using model::Encoding;
  using model::Format;
  const auto schema =
      sound(object("PHYSGEN(format(host, float32), format(cuda, half)) Scalar a;\n"
                   "  PHYSGEN(format(cuda, bfloat16)) Vector<3> b;\n"
                   "  PHYSGEN(range(0, 2), format(host, snorm16), format(cuda, float64)) Scalar c, d;\n"
                   "  PHYSGEN(format(host, quaternion()), format(cuda, quaternion(snorm16))) Rotation e[2];\n"
                   "  PHYSGEN(format(host, quaternion(half)), format(cuda, half)) Rotation f;\n  Scalar g;"));
  const std::vector<std::pair<Format, Format>> expected = {{{Encoding::float32, false}, {Encoding::half, false}},
                                                           {{}, {Encoding::bfloat16, false}},
                                                           {{Encoding::snorm16, false}, {Encoding::float64, false}},
                                                           {{Encoding::snorm16, false}, {Encoding::float64, false}},
                                                           {{Encoding::native, true}, {Encoding::snorm16, true}},
                                                           {{Encoding::half, true}, {Encoding::half, false}},
                                                           {{}, {}}};
  const auto& fields = schema.objects.at(0).fields;
  ASSERT_EQ(fields.size(), expected.size());
  for (std::size_t f = 0; f < fields.size(); ++f) {
    EXPECT_EQ(fields[f].host_format, expected[f].first) << fields[f].name;
    EXPECT_EQ(fields[f].cuda_format, expected[f].second) << fields[f].name;
    EXPECT_EQ(fields[f].format(model::Space::cuda), expected[f].second);
  }
}

TEST(Frontend, carries_doc_comments_of_objects_and_fields) {
  const auto schema = sound(
      "/// An object.\n/// Second line.\nstruct PHYSGEN_OBJECT(align(16)) A {\n"
      "  /// before\n  PHYSGEN(unit(\"m\")) Scalar a;\n"
      "  Scalar b, c;  ///< both\n"
      "  Scalar d,\n      e;  ///< both, over two lines\n"
      "  Scalar f,  ///< only f\n      g;  ///< only g\n"
      "  // not a doc comment\n  Scalar h;\n  /** block */\n  Scalar i;\n};\n");
  const auto& a = schema.objects.at(0);
  EXPECT_EQ(a.doc, "An object.\nSecond line.");
  const std::vector<std::string> expected = {
      "before", "both", "both", "both, over two lines", "both, over two lines", "only f", "only g", "", "block"};
  ASSERT_EQ(a.fields.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(a.fields[i].doc, expected[i]) << a.fields[i].name;
}

TEST(Frontend, keeps_namespaces_and_places) {
  const auto schema = sound("namespace a::b {\n" + object("Scalar first, second;") + "}\n");
  const auto& a = schema.objects.at(0);
  EXPECT_EQ(a.qualified_name(), "m::a::b::A");
  EXPECT_EQ(a.location, (model::Location{"schema.h", 4, 25}));
  EXPECT_EQ(a.fields.at(1).location, (model::Location{"schema.h", 5, 17}));
}

TEST(Frontend, reads_nested_and_imported_objects) {
  const Folder folder;
  const auto main = folder.write("schema.h", "#include \"parts/shape.h\"\n#include \"units.h\"\n" +
                                                 schema_of(object("shape::Corner corners[4]; Unit u;")));
  const auto shape = folder.write(
      "parts/shape.h", schema_of("namespace shape {\nstruct PHYSGEN_OBJECT() Corner {\n  Scalar x;\n};\n}\n"));
  const auto units = folder.write("more/units.h", schema_of("struct PHYSGEN_OBJECT() Unit {\n  Scalar x;\n};\n"));
  const auto result = parse_file(main, {folder / "more"});
  ASSERT_TRUE(result.schema.has_value()) << result.diagnostics;
  ASSERT_EQ(result.schema->imported.size(), 2u);
  EXPECT_EQ(result.schema->imported[0].qualified_name(), "m::shape::Corner");
  EXPECT_EQ(result.schema->imported[0].schema, "shape.h");
  EXPECT_EQ(result.schema->imported[1].schema, "units.h");
  ASSERT_EQ(result.schema->objects.size(), 1u);
  const auto& field = result.schema->objects[0].fields.at(0);
  EXPECT_EQ(field.shape, Shape::object);
  EXPECT_EQ(field.object, "m::shape::Corner");
  EXPECT_EQ(field.array_extent, 4);
  EXPECT_EQ(result.dependencies, (std::vector<std::string>{main, shape, units}));
}

TEST(Frontend, reports_errors_of_an_included_schema_in_its_file) {
  const Folder folder;
  const auto main = folder.write("main.h", "#include \"schema.h\"\n" + schema_of(object("Scalar x;")));
  folder.write("schema.h", schema_of("struct PHYSGEN_OBJECT() B {\n  Scalar* p;\n};\n"));
  const auto result = parse_file(main);
  EXPECT_FALSE(result.schema.has_value());
  ASSERT_EQ(headlines(result.diagnostics).size(), 1u) << result.diagnostics;
  EXPECT_EQ(headlines(result.diagnostics)[0].substr(0, 30), "4:3: error: field 'p' is a poi");
}

TEST(Frontend, underlines_what_is_wrong_as_clang_does) {
  const auto result = parse_text(schema_of(object("PHYSGEN(unit(\"m\"), range(2, 1)) Scalar x;")));
  EXPECT_NE(result.diagnostics.find("error: range(2, 1) is empty; write the lower end first, range(1, 2)\n"
                                    "    4 |   PHYSGEN(unit(\"m\"), range(2, 1)) Scalar x;\n"
                                    "      |                      ^~~~~~~~~~~\n"
                                    "1 error generated.\n"),
            std::string::npos)
      << result.diagnostics;
}

TEST(Frontend, says_that_system_headers_are_not_there) {
  const auto result = parse_text("#include <vector>\n" + schema_of(object("Scalar& x;")));
  EXPECT_NE(result.diagnostics.find("note: a schema can include <physgen/schema.h> and other schemas"),
            std::string::npos);
  EXPECT_EQ(headlines(result.diagnostics).size(), 2u) << "the missing header hides another error\n"
                                                      << result.diagnostics;
}

TEST(Frontend, says_what_an_empty_schema_needs) {
  for (const char* text : {"", "\n\n", "// only a comment\n"}) {
    const auto result = parse_text(text);
    EXPECT_FALSE(result.schema.has_value());
    ASSERT_EQ(headlines(result.diagnostics).size(), 1u) << result.diagnostics;
    EXPECT_EQ(
        headlines(result.diagnostics)[0],
        "1:1: error: this schema declares no object; write '#include <physgen/schema.h>' and 'struct PHYSGEN_OBJECT() "
        "Name { ... };' with the fields of one object");
  }
}

TEST(Frontend, says_what_to_write_instead_of_types_of_the_library) {
  for (const char* type : {"std::vector<double>", "Eigen::Vector3d", "Vector3d"}) {
    const auto result = parse_text(schema_of(object(std::string(type) + " x;")));
    EXPECT_NE(result.diagnostics.find("write Vector<3> for Eigen::Vector3d or std::array<double, 3>, Matrix<3, 3> for "
                                      "Eigen::Matrix3d, and for a std::vector an array of objects of its own"),
              std::string::npos)
        << result.diagnostics;
    EXPECT_EQ(result.diagnostics.find("options of fields"), std::string::npos) << result.diagnostics;
  }
}

TEST(Frontend, names_the_patterns_where_a_layout_is_misspelt) {
  for (const char* pattern : {"sao", "3"}) {
    const auto result = parse_text(
        schema_of("struct PHYSGEN_OBJECT(layout(host, " + std::string(pattern) + ")) A {\n  Scalar x;\n};\n"));
    EXPECT_NE(result.diagnostics.find("patterns aos, aos_padded, soa, aosoa(W)"), std::string::npos)
        << result.diagnostics;
  }
}

// Nesting doubles the fields thirty times: without a limit, gigabytes of code.
TEST(Frontend, refuses_nesting_that_explodes_at_the_field_that_is_too_large_and_says_it_once) {
  std::string text = "struct PHYSGEN_OBJECT() O0 {\n  Scalar x;\n};\n";
  for (int i = 1; i <= 30; ++i)
    text += "struct PHYSGEN_OBJECT() O" + std::to_string(i) + " {\n  O" + std::to_string(i - 1) + " a, b;\n};\n";
  const auto result = parse_text(schema_of(text));
  EXPECT_FALSE(result.schema.has_value());
  const auto found = headlines(result.diagnostics);
  ASSERT_EQ(found.size(), 1u) << result.diagnostics;
  EXPECT_TRUE(
      found[0].starts_with("40:3: error: object 'O12' would have 4096 fields, and the limit is 4000; the "
                           "fields of nested objects are listed one by one"))
      << found[0];
}

TEST(Frontend, survives_half_a_million_brackets_that_nothing_closes) {
  const auto result = parse_text(schema_of("struct PHYSGEN_OBJECT() A " + std::string(500000, '[')));
  EXPECT_FALSE(result.schema.has_value());
  EXPECT_NE(result.diagnostics.find("error: "), std::string::npos);
}

// Clang would evaluate 2^30 fields for the variable.
TEST(Frontend, does_not_let_a_variable_of_an_exploding_object_explode) {
  std::string text = "struct PHYSGEN_OBJECT() O0 {\n  Scalar x;\n};\n";
  for (int i = 1; i <= 30; ++i)
    text += "struct PHYSGEN_OBJECT() O" + std::to_string(i) + " {\n  O" + std::to_string(i - 1) + " a, b;\n} v" +
            std::to_string(i) + ";\n";
  const auto result = parse_text(schema_of(text));
  EXPECT_FALSE(result.schema.has_value());
  EXPECT_NE(result.diagnostics.find("object 'O12' would have 4096 fields"), std::string::npos) << result.diagnostics;
}

TEST(Frontend, refuses_a_schema_whose_objects_are_too_much_together) {
  std::string text = "struct PHYSGEN_OBJECT() O0 {\n  Scalar x;\n};\n";
  for (int i = 1; i <= 320; ++i)
    text += "struct PHYSGEN_OBJECT() O" + std::to_string(i) + " {\n  Scalar x; O" + std::to_string(i - 1) + " o;\n};\n";
  const auto result = parse_text(schema_of(text));
  EXPECT_FALSE(result.schema.has_value());
  const auto found = headlines(result.diagnostics);
  ASSERT_GE(found.size(), 1u);
  EXPECT_NE(
      found[0].find("the generated header would exceed 8 MiB; move it and those after it to a schema of their own"),
      std::string::npos)
      << found[0];
}

TEST(Frontend, does_not_see_the_headers_of_the_host) {
  sound("#if __has_include(<vector>) || __has_include(<stdint.h>)\n#error the host's\n#endif\n" + object("Scalar x;"));
}

TEST(Frontend, accepts_harmless_declarations_beside_objects) {
  sound(
      "#pragma once\nstruct Helper;\nenum class Kind { soft };\nconstexpr int twice(int n) { return 2 * n; }\n"
      "struct PHYSGEN_OBJECT() Later;\nnamespace { constexpr int n = 3; }\nstatic_assert(n == 3);\n" +
      object("static_assert(n == 3); public: Vector<twice(n)> x;") +
      "extern \"C++\" {\nstruct PHYSGEN_OBJECT() B {\n  A a;\n};\n}\n");
}

TEST(Frontend, survives_comments_that_are_not_utf8) {
  const auto result =
      parse_text(schema_of("/// 20 \xb0"
                           "C\n" +
                           object("Scalar x;  ///< \xff\xfe")));
  EXPECT_TRUE(result.schema.has_value()) << result.diagnostics;
}

TEST(Frontend, gives_the_same_model_every_time) {
  const std::string text = schema_of(object("Scalar x; Symmetric<3> k[4];"));
  EXPECT_EQ(parse_text(text).schema, parse_text(text).schema);
}

}  // namespace
}  // namespace physgen::test
