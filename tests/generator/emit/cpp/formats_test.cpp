// The text about storage formats: the formats struct, what comments say of them, the record computed from them, and the
// proofs of either memory space.
#include <gtest/gtest.h>

#include <cmath>

#include "emit/cpp/header.h"
#include "emit/cpp/text.h"
#include "models.h"
#include "text_checks.h"

namespace physgen::emit::cpp {
namespace {

using model::Element;
using model::Encoding;
using model::Shape;
using model::Space;
using test::array;
using test::expect_contains;
using test::field;
using test::nested;
using test::object;
using test::rotation;
using test::scalar;
using test::schema;
using test::stored;
using test::stored_on_cuda;

std::string header(std::vector<model::Field> fields) {
  return accessor_header(schema({object("A", std::move(fields))}));
}

model::Field in_range(model::Field made, double low, double high) {
  made.range = model::Range{low, high};
  return made;
}

std::string host_type(const model::Field& declared) { return format_type(declared, Space::host); }

TEST(Formats, are_listed_per_field_in_order_of_declaration) {
  expect_contains(header({scalar("x"), stored(scalar("y"), Encoding::half), scalar("i", Element::index),
                          stored(field("F", Shape::matrix, 3, 3), Encoding::bfloat16)}),
                  "template <class Space>\nstruct AFormats {\n"
                  "  using x = physgen::format::Native;\n"
                  "  using y = physgen::format::Half<>;\n"
                  "  using i = physgen::format::Native;\n"
                  "  using F = physgen::format::Bfloat16;\n};\n");
}

TEST(Formats, choose_by_space_only_where_spaces_differ) {
  const std::string text = header({stored_on_cuda(scalar("x"), Encoding::half), stored(scalar("y"), Encoding::half)});
  expect_contains(text, "  using x = physgen::PerSpace<Space, physgen::format::Native, physgen::format::Half<>>;\n");
  expect_contains(text, "  using y = physgen::format::Half<>;\n");
}

TEST(Formats, of_nested_objects_are_those_of_their_type) {
  auto imported = object("P", {stored(scalar("x"), Encoding::half)}, "other");
  imported.schema = "other.h";
  auto all = schema({object("B", {scalar("x")}), object("A", {nested("b", "test::B"), nested("p", "other::P")})});
  all.imported = {imported};
  const std::string text = accessor_header(all);
  expect_contains(text, "struct AFormats {\n  using b = BFormats<Space>;\n  using p = ::other::PFormats<Space>;\n};\n");
  expect_contains(text, "  using b = physgen::NestedField<ARecord, 0, BObject, typename Formats::b, Real>;\n");
  expect_contains(text, "  using p = physgen::NestedField<ARecord, 1, ::other::PObject, typename Formats::p, Real>;\n");
  expect_contains(text, "PHYSGEN_FUNCTION decltype(auto) b() const { return this->field_(typename Record::b(), ");
  expect_contains(text, "texts = {{{\"b.x\"}, {\"p.x\"}}};\n");
}

TEST(Formats, of_integers_have_entries_as_those_of_real_numbers_do) {
  const std::string text = header({scalar("i", Element::index), field("v", Shape::vector, 4, 1, Element::index)});
  expect_contains(text, "  using i = physgen::format::Native;\n  using v = physgen::format::Native;\n");
  expect_contains(text, "StoredField<ARecord, 0, physgen::shape::Scalar, typename Formats::i, std::int32_t>;");
  expect_contains(text, "StoredField<ARecord, 1, physgen::shape::Vector<4>, typename Formats::v, std::int32_t>;");
}

TEST(Probes, number_the_fields_as_the_list_of_fields_does) {
  auto all = schema({object("B", {scalar("x"), scalar("y")}),
                     object("A", {scalar("m"), nested("b", "test::B"), nested("c", "test::B"), scalar("n")})});
  all.objects[1].fields[1].array_extent = 3;
  const std::string text = accessor_header(all);
  expect_contains(text,
                  "struct AObject;\n"
                  "template <class ArrayTag, class Base = AFormats<physgen::Host>, class Object = AObject, "
                  "int first = 0>\n"
                  "struct AProbe {\n"
                  "  using array_ = ArrayTag;\n"
                  "  using m = physgen::Probe<ArrayTag, Object, first + 0, typename Base::m>;\n"
                  "  using b = BProbe<ArrayTag, typename Base::b, Object, first + 1>;\n"
                  "  using c = BProbe<ArrayTag, typename Base::c, Object, first + 7>;\n"
                  "  using n = physgen::Probe<ArrayTag, Object, first + 9, typename Base::n>;\n};\n");
  expect_contains(text, "struct AObject : physgen::ObjectTag<AObject, A, AFormats, ARecord, ARef, AProbe> {\n");
}

TEST(Probes, give_way_to_fields_that_are_called_as_their_parameters) {
  const std::string text = header({scalar("Base"), scalar("first"), scalar("Object"), scalar("ArrayTag")});
  expect_contains(text, "  using Base = physgen::Probe<ArrayTag_, Object_, first_ + 0, typename Base_::Base>;\n");
}

TEST(Formats, are_spelled_as_the_runtime_calls_them) {
  EXPECT_EQ(host_type(scalar("x")), "physgen::format::Native");
  EXPECT_EQ(host_type(stored(scalar("x"), Encoding::float32)), "physgen::format::Float32");
  EXPECT_EQ(host_type(stored(scalar("x"), Encoding::float64)), "physgen::format::Float64");
  EXPECT_EQ(host_type(stored(scalar("x"), Encoding::bfloat16)), "physgen::format::Bfloat16");
  EXPECT_EQ(host_type(stored(rotation("R"), Encoding::native, true)), "physgen::format::Quaternion<>");
  EXPECT_EQ(host_type(stored(rotation("R"), Encoding::float64, true)),
            "physgen::format::Quaternion<physgen::format::Float64>");
  EXPECT_EQ(host_type(stored(rotation("R"), Encoding::half, true)),
            "physgen::format::Quaternion<physgen::format::Half<>>");
  EXPECT_EQ(host_type(stored(rotation("R"), Encoding::snorm16, true)), "physgen::format::Quaternion16");
  EXPECT_EQ(host_type(stored(rotation("R"), Encoding::snorm16)),
            "physgen::format::Snorm16<physgen::format::Interval{-1.0, 1.0}>");
}

TEST(Formats, spell_the_ends_of_equal_steps_as_decimals) {
  const auto steps = [](double low, double high) {
    return host_type(in_range(stored(scalar("x"), Encoding::snorm16), low, high));
  };
  EXPECT_EQ(steps(0, 1), "physgen::format::Snorm16<physgen::format::Interval{0.0, 1.0}>");
  EXPECT_EQ(steps(-3.25, 20000), "physgen::format::Snorm16<physgen::format::Interval{-3.25, 20000.0}>");
  EXPECT_EQ(steps(-1e300, 1e-12), "physgen::format::Snorm16<physgen::format::Interval{-1e+300, 1e-12}>");
}

TEST(Formats, of_half_bring_the_larger_end_of_the_range_to_32768) {
  const auto half = [](double low, double high) {
    return host_type(in_range(stored(scalar("x"), Encoding::half), low, high));
  };
  EXPECT_EQ(host_type(stored(scalar("x"), Encoding::half)), "physgen::format::Half<>") << "no range";
  EXPECT_EQ(half(0, 1e6), "physgen::format::Half<5>");   // 31250 of 32768
  EXPECT_EQ(half(-1e6, 1), "physgen::format::Half<5>");  // whatever its sign
  EXPECT_EQ(half(0, 1), "physgen::format::Half<-15>");
  EXPECT_EQ(half(0, 32768), "physgen::format::Half<>");
  EXPECT_EQ(half(0, 32769), "physgen::format::Half<1>");
  EXPECT_EQ(half(0, 16384), "physgen::format::Half<-1>");
  EXPECT_EQ(half(0, 0), "physgen::format::Half<>");
}

TEST(Formats, of_half_leave_every_range_a_factor_of_two_and_use_more_than_a_quarter) {
  for (double size = 1e-25; size < 1e30; size *= 1.37) {
    const std::string type = host_type(in_range(stored(scalar("x"), Encoding::half), -size, size / 2));
    const std::string exponent = type.substr(type.find('<') + 1, type.size() - type.find('<') - 2);
    const double scaled = std::ldexp(size, exponent.empty() ? 0 : -std::stoi(exponent));
    EXPECT_GT(scaled, 16384) << size << " as " << type;
    EXPECT_LE(scaled, 32768) << size << " as " << type;
  }
}

TEST(Formats, of_rotations_do_not_follow_a_range) {
  EXPECT_EQ(host_type(in_range(stored(rotation("R"), Encoding::half), -1, 1)), "physgen::format::Half<>");
  EXPECT_EQ(host_type(in_range(stored(rotation("R"), Encoding::snorm16), -2, 2)),
            "physgen::format::Snorm16<physgen::format::Interval{-1.0, 1.0}>");
  // Halves of entries up to 1 are precise from 6.1e-5 on, as the comment must say.
  EXPECT_EQ(field_comment(in_range(stored(rotation("R"), Encoding::half), -1, 1)),
            "Rotation, 9 stored. Range [-1, 1]. Stored as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to "
            "6.6e+04.");
}

TEST(Comments, say_the_worst_error_of_a_format) {
  EXPECT_EQ(field_comment(stored(scalar("x"), Encoding::float32)), "Stored as float, relative error up to 6e-8.");
  EXPECT_EQ(field_comment(stored(scalar("x"), Encoding::float64)), "Stored as double, relative error up to 1.2e-16.");
  EXPECT_EQ(field_comment(stored(scalar("x"), Encoding::bfloat16)), "Stored as bfloat16, relative error up to 3.9e-3.");
  EXPECT_EQ(field_comment(stored(scalar("x"), Encoding::half)),
            "Stored as half, relative error up to 4.9e-4 for sizes from 6.1e-05 to 6.6e+04.");
  EXPECT_EQ(field_comment(in_range(stored(scalar("x"), Encoding::half), 0, 1e6)),
            "Range [0, 1e+06]. Stored as half, relative error up to 4.9e-4 for sizes from 0.002 to 2.1e+06.");
  EXPECT_EQ(field_comment(in_range(stored(scalar("x"), Encoding::snorm16), -1, 1)),
            "Range [-1, 1]. Stored as 16-bit steps over [-1, 1], error up to 1.6e-05.");
}

TEST(Comments, say_what_becomes_of_a_rotation_that_is_a_quaternion) {
  auto turn = stored(rotation("R"), Encoding::snorm16, true);
  turn.doc = "of the rest shape";
  EXPECT_EQ(field_comment(turn).substr(0, 29), "of the rest shape. Rotation, ");
  expect_contains(field_comment(turn), "Stored as unit quaternion of 16-bit steps, error of an entry up to 9e-5.");
  expect_contains(field_comment(stored(rotation("R"), Encoding::native, true)),
                  "Stored as unit quaternion, error of an entry up to 10 eps.");
  expect_contains(field_comment(stored(rotation("R"), Encoding::half, true)),
                  "Stored as unit quaternion of halves, error of an entry up to 2e-3.");
}

TEST(Comments, say_of_each_space_what_differs) {
  EXPECT_EQ(field_comment(stored_on_cuda(scalar("x"), Encoding::bfloat16)),
            "Stored on CUDA as bfloat16, relative error up to 3.9e-3.");
  auto both = stored_on_cuda(scalar("x"), Encoding::bfloat16);
  both.host_format.encoding = Encoding::float32;
  EXPECT_EQ(
      field_comment(both),
      "Stored on the host as float, relative error up to 6e-8; on CUDA as bfloat16, relative error up to 3.9e-3.");
  std::swap(both.host_format, both.cuda_format);
  both.cuda_format = {};
  EXPECT_EQ(field_comment(both), "Stored on the host as bfloat16, relative error up to 3.9e-3.");
}

TEST(Comments, stand_at_members_and_accessors) {
  const std::string text = header({stored(scalar("x"), Encoding::bfloat16)});
  const std::string comment = "  /// Stored as bfloat16, relative error up to 3.9e-3.\n";
  expect_contains(text, comment + "  Real x = {};\n");
  expect_contains(text, comment + "  PHYSGEN_FUNCTION decltype(auto) x() const { return ");
}

TEST(Proofs, carry_bytes_alignment_and_all_offsets_in_order_of_declaration) {
  const std::string text = header({stored(scalar("h"), Encoding::half), scalar("x"), scalar("d", Element::float64)});
  expect_contains(
      text,
      "static_assert(physgen::are_sound_records<AObject, physgen::Host>({14, 8, {12, 8, 0}}, {18, 8, {16, 0, 8}}));\n");
}

TEST(Proofs, are_given_for_cuda_only_where_it_differs) {
  EXPECT_EQ(header({stored(scalar("x"), Encoding::half)}).find("AObject, physgen::Cuda>"), std::string::npos);
  // As many bytes in the same places: one proof is enough.
  auto other = stored(scalar("x"), Encoding::half);
  other.cuda_format.encoding = Encoding::bfloat16;
  EXPECT_EQ(header({other}).find("AObject, physgen::Cuda>"), std::string::npos);
  const std::string text = header({stored_on_cuda(rotation("R"), Encoding::half, true), scalar("x")});
  expect_contains(text, "<AObject, physgen::Host>({40, 4, {0, 36}}, {80, 8, {0, 72}}));\n");
  expect_contains(text, "<AObject, physgen::Cuda>({12, 4, {4, 0}}, {16, 8, {8, 0}}));\n");
}

TEST(Proofs, follow_formats_into_arrays_of_nested_objects) {
  const std::string text =
      accessor_header(schema({object("B", {stored_on_cuda(scalar("h"), Encoding::half), scalar("x")}),
                              object("A", {array(nested("b", "test::B"), 2), scalar("i", Element::index)})}));
  expect_contains(text, "<AObject, physgen::Cuda>(\n    {20, 4, {4, 0, 12, 8, 16}}, {36, 8, ");
  expect_contains(text, "texts = {{{\"b[0].h\"}, {\"b[0].x\"}, {\"b[1].h\"}, {\"b[1].x\"}, {\"i\"}}};\n");
}

}  // namespace
}  // namespace physgen::emit::cpp
