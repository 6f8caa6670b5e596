// The text of generated headers, from models built by hand.
#include <gtest/gtest.h>
#include <physgen/config.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <sstream>

#include "emit/cpp/header.h"
#include "emit/cpp/header_size.h"
#include "emit/cpp/text.h"
#include "emit/emitter.h"
#include "emit/printer.h"
#include "model/text.h"
#include "models.h"
#include "text_checks.h"

namespace physgen::emit::cpp {
namespace {

using model::Element;
using model::Shape;
using test::array;
using test::expect_contains;
using test::field;
using test::nested;
using test::object;
using test::scalar;
using test::schema;

TEST(Emitter, is_written_for_this_runtime) { EXPECT_EQ(runtime_version, PHYSGEN_RUNTIME_VERSION); }

TEST(Emitter, names_generated_headers_after_their_schemas) {
  const Emitter& emitter = emit::emitter("cpp");
  EXPECT_EQ(file_of(emitter, "elasticity.h"), "elasticity.physgen.h");
  EXPECT_EQ(file_of(emitter, "some.folder/tissue.model.hpp"), "tissue.model.physgen.h");
  EXPECT_EQ(file_of(emitter, "folder.d/plain"), "plain.physgen.h");
  EXPECT_EQ(file_of(emitter, ".hidden"), ".hidden.physgen.h");
}

TEST(Emitters, are_found_by_their_names_and_the_nearest_is_named) {
  for (const Emitter& one : emitters()) EXPECT_EQ(&emitter(std::string(one.name)), &one);
  const auto error_of = [](const char* name) {
    try {
      (void)emitter(name);
    } catch (const UnknownEmitter& error) {
      return std::string(error.what());
    }
    return std::string("found");
  };
  EXPECT_EQ(error_of("cppp"), "there is no emitter 'cppp'; did you mean 'cpp'?");
  EXPECT_EQ(error_of("fortran"), "there is no emitter 'fortran'; there are cpp and python");
}

TEST(Emitter, refuses_another_runtime_by_an_error) {
  const std::string text = accessor_header(schema({object("A", {scalar("x")})}));
  expect_contains(text, "#if PHYSGEN_RUNTIME_VERSION != 7\n#error \"test.physgen.h is for version 7 of the physgen");
}

TEST(Emitter, refuses_a_schema_before_it_by_an_error) {
  const std::string text = accessor_header(schema({object("A", {scalar("x")})}));
  expect_contains(text,
                  "#ifdef PHYSGEN_SCHEMA_H\n#error \"a program includes test.physgen.h in place of the schema: remove "
                  "the #include of the schema\"\n#endif\n#define PHYSGEN_GENERATED_HEADER\n");
}

TEST(Emitter, writes_the_same_text_for_the_same_model) {
  const auto all = schema({object("A", {scalar("x"), field("F", Shape::matrix, 3, 3)}), object("B", {scalar("y")})});
  EXPECT_EQ(accessor_header(all), accessor_header(all));
}

TEST(Emitter, does_not_depend_on_where_the_schema_lies) {
  auto all = schema({object("A", {scalar("x")})});
  const std::string text = accessor_header(all);
  all.objects[0].location = {"/somewhere/else/test.h", 7, 3};
  all.objects[0].fields[0].location = {"/somewhere/else/test.h", 8, 3};
  EXPECT_EQ(accessor_header(all), text);
}

TEST(Emitter, says_shape_format_and_type_of_a_field_once) {
  const std::string text = accessor_header(schema({object("A", {scalar("x"), field("F", Shape::matrix, 3, 3)})}));
  expect_contains(text,
                  "template <class Real, class Formats>\nstruct ARecord {\n"
                  "  using x = physgen::StoredField<ARecord, 0, physgen::shape::Scalar, typename Formats::x, Real>;\n"
                  "  using F = physgen::StoredField<ARecord, 1, physgen::shape::Matrix<3, 3>, typename Formats::F, "
                  "Real>;\n"
                  "  using fields_ = physgen::RecordFields<x, F>;\n};\n");
  for (const char* word : {"shape::Scalar", "shape::Matrix"}) EXPECT_EQ(text.find(word), text.rfind(word)) << word;
  expect_contains(text,
                  "  PHYSGEN_FUNCTION decltype(auto) x() const { return this->field_(typename Record::x(), "
                  "Record::x::offset); }\n"
                  "  PHYSGEN_FUNCTION decltype(auto) F() const { return this->field_(typename Record::F(), "
                  "Record::F::offset); }\n");
  expect_contains(text, "  PHYSGEN_FUNCTION const Value get() const { return {x(), F().get()}; }\n");
  expect_contains(text,
                  "static_assert(physgen::are_sound_records<AObject, physgen::Host>({40, 4, {0, 4}}, "
                  "{80, 8, {0, 8}}));\n");
}

TEST(Emitter, carries_docs_units_ranges_and_initial_values) {
  auto density = scalar("density");
  density.doc = "Mass per volume.\nOf the rest shape";
  density.unit = "kg/m^3";
  density.range = model::Range{0, 0.5};
  density.initial = 0.1;
  auto stiffness = field("K", Shape::symmetric, 3, 3);
  stiffness.unit = "N/m";
  auto weights = scalar("w");
  weights.array_extent = 4;
  weights.initial = 0.25;
  const std::string text = accessor_header(schema({object("A", {density, stiffness, weights})}));
  const std::string comment =
      "  /// Mass per volume.\n  /// Of the rest shape [kg/m^3]. Range [0, 0.5]; initially 0.1.\n";
  expect_contains(text, comment + "  Real density = physgen::all_lanes<Real>(0.1);\n");
  expect_contains(text, comment + "  PHYSGEN_FUNCTION decltype(auto) density() const");
  expect_contains(text,
                  "  /// [N/m]. Symmetric, 6 stored.\n  physgen::MatrixValue<Real, 3, 3> K = decltype(K)::Zero();\n");
  expect_contains(text, "  /// Initially 0.25 in a new array.\n  Real w[4] = {};\n");
  expect_contains(text,
                  "  static constexpr std::array<physgen::FieldText, 3> texts = {{\n"
                  "      {\"density\", \"kg/m^3\", 0.1}, {\"K\", \"N/m\"}, {\"w\", \"\", 0.25}}};\n");
}

TEST(Emitter, uses_the_declared_layouts_or_the_runtimes_default) {
  auto padded = object("A", {scalar("x")});
  padded.host_layout = model::Layout{model::LayoutKind::aos_padded, 0};
  padded.cuda_layout = model::Layout{model::LayoutKind::aosoa, 64};
  const std::string text = accessor_header(schema({padded, object("B", {scalar("x")})}));
  expect_contains(text,
                  "physgen::PerSpace<Space, physgen::AosPadded, physgen::Aosoa<64>>,\n          "
                  "class Formats = physgen::FormatsOf<AObject, Space>>\nusing AArray");
  expect_contains(text,
                  "physgen::PerSpace<Space, physgen::Aosoa<16>, physgen::Aosoa<32>>,\n          "
                  "class Formats = physgen::FormatsOf<BObject, Space>>\nusing BArray");
}

TEST(Emitter, includes_the_headers_of_imported_objects_once) {
  auto first = object("P", {scalar("x")}, "other"), second = object("Q", {scalar("x")}, "other");
  first.schema = second.schema = "other.h";
  auto all = schema({object("A", {nested("p", "other::P"), nested("q", "other::Q")})});
  all.imported = {first, second};
  const std::string text = accessor_header(all);
  const std::string include = "#include \"other.physgen.h\"\n";
  expect_contains(text, include);
  EXPECT_EQ(text.find(include), text.rfind(include));
  expect_contains(text, "  ::other::P<Real> p;\n");
  EXPECT_EQ(text.find("struct P "), std::string::npos);
}

TEST(Emitter, opens_each_namespace_once_for_objects_that_follow_each_other) {
  const std::string text = accessor_header(
      schema({object("A", {scalar("x")}, "a::b"), object("B", {scalar("x")}, "a::b"), object("C", {scalar("x")}, "")}));
  EXPECT_EQ(text.find("namespace a::b {"), text.rfind("namespace a::b {"));
  EXPECT_LT(text.find("}  // namespace a::b"), text.find("struct C {"));
  expect_contains(text, "std::string_view name = \"C\";");
}

TEST(Emitter, keeps_its_local_names_apart_from_fields) {
  const std::string text = accessor_header(schema({object("A", {scalar("value"), array(scalar("entry"), 33)})}));
  expect_contains(text, "    value_.value = value();\n");
  expect_contains(text, "for (int entry_ = 0; entry_ < 33; ++entry_) entry(entry_) = value_.entry[entry_];\n");
}

TEST(Emitter, writes_no_line_that_is_too_long_or_ends_in_blanks) {
  auto wordy = scalar("x");
  for (int i = 0; i < 60; ++i) wordy.doc += "words ";
  const auto inner = object("InnerObjectWithAQuiteLongName", {wordy, scalar("d", Element::float64)});
  const auto outer = object("OuterObjectWithAQuiteLongName",
                            {array(nested("entries", "test::InnerObjectWithAQuiteLongName"), 3), scalar("x")});
  std::istringstream lines(accessor_header(schema({inner, outer})));
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), Printer::columns) << line;
    EXPECT_TRUE(line.empty() || line.back() != ' ') << line;
    EXPECT_EQ(line.find('\r'), std::string::npos);
  }
}

// As integers, numbers of 20 digits are taken modulo 2^64, and -0 loses its sign.
TEST(Emitter, prints_initial_values_as_literals_of_their_type) {
  const auto line_of = [](Element element, double value) {
    auto with_value = scalar("x", element);
    with_value.initial = value;
    const std::string text = accessor_header(schema({object("A", {with_value})}));
    const auto begin = text.find(" x = ") + 5;
    return text.substr(begin, text.find(';', begin) - begin);
  };
  EXPECT_EQ(line_of(Element::real, 0x1p64), "physgen::all_lanes<Real>(18446744073709551616.0)");
  EXPECT_EQ(line_of(Element::float64, 0x1p64), "18446744073709551616.0");
  EXPECT_EQ(line_of(Element::float64, 1.2345678901234568e20), "123456789012345683968.0");
  EXPECT_EQ(line_of(Element::float32, 0x1p64), "18446744073709551616.0f");
  EXPECT_EQ(line_of(Element::float64, -0.0), "-0.0");
  EXPECT_EQ(line_of(Element::float64, 1e-12), "1e-12");
  EXPECT_EQ(line_of(Element::index, 1e9), "1000000000");
  EXPECT_EQ(line_of(Element::int32, -2147483648.0), "-2147483648");
  EXPECT_EQ(line_of(Element::int64, -0x1p63), "-9223372036854775807 - 1");
  EXPECT_EQ(line_of(Element::int64, 0x1p62), "4611686018427387904");
  EXPECT_EQ(line_of(Element::uint64, 18446744073709549568.0), "18446744073709549568U");
  EXPECT_EQ(line_of(Element::boolean, 1), "true");
  auto with_value = scalar("x");
  with_value.initial = 0x1p64;
  expect_contains(accessor_header(schema({object("A", {with_value})})),
                  "texts = {{{\"x\", \"\", 18446744073709551616.0}}};\n");
}

TEST(Emitter, writes_what_the_schema_says_of_fields_as_literals) {
  auto said = scalar("x"), long_said = scalar("y");
  said.doc = "a \"quoted\" \\ word?\?/\r\nand a line";
  long_said.doc = std::string(80, 'a') + " " + std::string(60, 'b');
  const std::string text = accessor_header(schema({object("A", {said, scalar("none"), long_said})}));
  expect_contains(text,
                  "  static constexpr std::array<std::string_view, 3> docs = {\n"
                  "    \"a \\\"quoted\\\" \\\\ word\\?\\?/\\nand a line\", \"\",\n    \"" +
                      std::string(80, 'a') + " \"\n");
  EXPECT_EQ(accessor_header(schema({object("B", {scalar("z")})})).find("docs"), std::string::npos);
}

TEST(Emitter, guards_a_header_by_the_name_of_its_schema_and_its_text) {
  const auto guard_of = [](const model::Schema& made) {
    const std::string text = accessor_header(made);
    const auto begin = text.find("#ifndef ") + 8;
    const std::string guard = text.substr(begin, text.find('\n', begin) - begin);
    EXPECT_EQ(text.find("#pragma once"), std::string::npos);
    expect_contains(text, "#ifndef " + guard + "\n#define " + guard + "\n\n#include <physgen/runtime.h>\n");
    EXPECT_TRUE(text.ends_with("\n#endif  // " + guard + "\n"));
    return guard;
  };
  auto made = schema({object("A", {scalar("x")})});
  made.file = "tissue.model-2__b.h";
  const std::string guard = guard_of(made);
  EXPECT_EQ(guard.substr(0, 29), "PHYSGEN_TISSUE_MODEL_2_B_H_" + guard.substr(27, 2)) << guard;
  EXPECT_EQ(guard, guard_of(made));
  made.objects[0].name = "B";  // a different schema of the same file name
  EXPECT_NE(guard, guard_of(made));
}

// The estimate decides what is refused before anything is written.
TEST(Emitter, writes_about_as_much_as_was_estimated) {
  const auto compare = [](const char* what, const model::Schema& made) {
    HeaderSizes sizes;
    double estimate = 0;
    for (const auto& one : made.objects) estimate += sizes.of(one).bytes;
    const auto bytes = static_cast<double>(accessor_header(made).size());
    EXPECT_GT(estimate, 0.75 * bytes) << what;
    EXPECT_LT(estimate, 1.5 * bytes) << what;
    std::cout << what << ": estimate / bytes " << estimate / bytes << '\n';
  };
  compare("one scalar", schema({object("A", {scalar("x")})}));
  std::vector<model::Field> many;
  for (int f = 0; f < 1000; ++f) many.push_back(scalar("some_name_" + std::to_string(f)));
  compare("many fields", schema({object("A", many)}));
  for (auto& one : many) one.doc = std::string(500, 'x');
  compare("long comments", schema({object("A", many)}));
  compare("an array", schema({object("A", {scalar("x")}), object("B", {array(nested("a", "test::A"), 5000)})}));
  compare("long names", schema({object(std::string(500, 'A'), {scalar(std::string(300, 'x'))}),
                                object(std::string(700, 'B'), {nested("a", "test::" + std::string(500, 'A'))})}));
  std::vector<model::Object> chain{object("O0", {scalar("x")})}, doubled{object("O0", {scalar("x")})};
  for (int i = 1; i <= 70; ++i)
    chain.push_back(object("O" + std::to_string(i), {scalar("x"), nested("o", "test::O" + std::to_string(i - 1))}));
  compare("a chain", schema(chain));
  for (int i = 1; i <= 11; ++i) {
    const std::string inner = "test::O" + std::to_string(i - 1);
    doubled.push_back(object("O" + std::to_string(i), {nested("a", inner), nested("b", inner)}));
  }
  compare("a tree", schema(doubled));
  compare("a tree of arrays",
          schema({object("A", {scalar("x"), scalar("y")}), object("B", {array(nested("a", "test::A"), 12)}),
                  object("C", {array(nested("b", "test::B"), 12)}), object("D", {array(nested("c", "test::C"), 12)})}));
}

TEST(Emitter, lets_no_comment_swallow_the_next_line) {
  auto sly = scalar("x");
  sly.doc = "first \\\r\nsecond \\ ?\?/ ";
  const std::string text = accessor_header(schema({object("A", {sly})}));
  expect_contains(text, "  /// first\n  /// second\n  Real x = {};\n");
}

TEST(Emitter, prints_the_times_of_few_and_of_many_objects) {
  std::vector<model::Object> objects;
  for (int o = 0; o < 1000; ++o) {
    std::vector<model::Field> fields;
    for (int f = 0; f < 12; ++f) fields.push_back(scalar("x" + std::to_string(f)));
    objects.push_back(object("Object" + std::to_string(o), fields));
  }
  const auto all = schema(objects);
  const auto begin = std::chrono::steady_clock::now();
  const std::size_t bytes = accessor_header(all).size();
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
  EXPECT_GT(bytes, 1000U * 12U);
  std::cout << "1000 objects of 12 scalars: " << took.count() << " ms, " << bytes << " bytes\n";
}

TEST(Text, writes_the_shortest_number_that_reads_back) {
  EXPECT_EQ(model::number(0.1), "0.1");
  EXPECT_EQ(model::number(1060), "1060");
  EXPECT_EQ(model::number(1e-12), "1e-12");
}

}  // namespace
}  // namespace physgen::emit::cpp
