// Plans of records: where fields lie, in each memory space and for both precisions. What is wrong with a record is
// proof_test.cpp's.
#include "plan/plan.h"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

#include "models.h"
#include "plan/proof.h"

namespace physgen::plan {
namespace {

using namespace model;  // enumerations of schemas
using namespace test;   // models.h

TEST(Plan, packs_real_fields_in_order_of_declaration) {
  const auto svd = object("DeformationSvd", {field("U", Shape::rotation, 3, 3), field("V", Shape::rotation, 3, 3),
                                             field("s", Shape::diagonal, 3, 3)});
  const Record record = plan_record(svd, Space::host, no_objects);
  EXPECT_EQ(record.slots[0].offset, (Bytes{0, 0}));
  EXPECT_EQ(record.slots[1].offset, (Bytes{36, 72}));
  EXPECT_EQ(record.slots[2].offset, (Bytes{72, 144}));
  EXPECT_EQ(record.bytes, (Bytes{84, 168}));
  EXPECT_EQ(record.alignment, (Bytes{4, 8}));
  EXPECT_EQ(violations(record), std::vector<std::string>{});
}

TEST(Plan, orders_fields_by_size_and_leaves_no_gap_between_them) {
  const auto mixed = object("Mixed", {scalar("i", Element::index), scalar("r"), scalar("d", Element::float64),
                                      scalar("f", Element::float32), scalar("q"), scalar("e", Element::float64)});
  const Record record = plan_record(mixed, Space::host, no_objects);
  // 8 bytes first, in order of declaration: d, e, or r, d, q, e where Real is double; then 4 bytes.
  EXPECT_EQ(record.slots[2].offset, (Bytes{0, 8}));
  EXPECT_EQ(record.slots[5].offset, (Bytes{8, 24}));
  EXPECT_EQ(record.slots[1].offset, (Bytes{20, 0}));
  EXPECT_EQ(record.slots[4].offset, (Bytes{28, 16}));
  EXPECT_EQ(record.slots[0].offset, (Bytes{16, 32}));
  EXPECT_EQ(record.slots[3].offset, (Bytes{24, 36}));
  EXPECT_EQ(record.bytes, (Bytes{32, 40}));
  EXPECT_EQ(record.alignment, (Bytes{8, 8}));
  EXPECT_EQ(violations(record), std::vector<std::string>{});
}

TEST(Plan, counts_the_stored_elements_of_every_structure) {
  const auto all = object(
      "All", {field("symmetric", Shape::symmetric, 3, 3), field("diagonal", Shape::diagonal, 3, 3),
              field("skew", Shape::skew, 3, 3), field("rotation", Shape::rotation, 3, 3),
              field("matrix", Shape::matrix, 2, 5), array(field("vectors", Shape::vector, 3), 4), scalar("end")});
  const Record record = plan_record(all, Space::host, no_objects);
  const std::vector<int> counts{6, 3, 3, 9, 10, 12, 1};
  int before = 0;
  for (std::size_t f = 0; f < counts.size(); ++f) {
    EXPECT_EQ(record.slots[f].offset, (Bytes{4 * before, 8 * before})) << all.fields[f].name;
    before += counts[f];
  }
  EXPECT_EQ(record.slots[5].stride, (Bytes{12, 24}));
  EXPECT_EQ(record.bytes, (Bytes{4 * before, 8 * before}));
}

TEST(Plan, embeds_nested_objects_whole_and_rounded_up_to_their_alignment) {
  const auto all = schema({object("Odd", {scalar("d", Element::float64), scalar("i", Element::int32)}),  // 12 bytes
                           object("Outer", {scalar("i", Element::int32), array(nested("odds", "test::Odd"), 2)})});
  const Records records(all, Space::host);
  EXPECT_EQ(records.of("test::Odd").bytes, (Bytes{12, 12}));
  const Record& outer = records.of("test::Outer");
  EXPECT_EQ(outer.slots[1].offset, (Bytes{0, 0}));
  EXPECT_EQ(outer.slots[1].stride, (Bytes{16, 16}));
  EXPECT_EQ(outer.slots[0].offset, (Bytes{32, 32}));
  EXPECT_EQ(outer.bytes, (Bytes{36, 36}));
  EXPECT_EQ(violations(outer), std::vector<std::string>{});
}

TEST(Plan, places_nested_objects_by_their_alignment_in_each_precision) {
  const auto all = schema({object("Reals", {scalar("x"), scalar("i", Element::int32)}),
                           object("Ints", {scalar("i", Element::int32)}),
                           object("Outer", {nested("ints", "test::Ints"), scalar("x"), nested("reals", "test::Reals"),
                                            scalar("d", Element::float64)})});
  const Records records(all, Space::host);
  const Record& outer = records.of("test::Outer");
  EXPECT_EQ(outer.slots[3].offset, (Bytes{0, 24}));  // d: behind all of its size that are declared before it
  EXPECT_EQ(outer.slots[0].offset, (Bytes{8, 32}));  // ints: 4 bytes aligned, whatever Real is
  EXPECT_EQ(outer.slots[1].offset, (Bytes{12, 0}));  // x
  EXPECT_EQ(outer.slots[2].offset, (Bytes{16, 8}));  // reals
  EXPECT_EQ(outer.slots[2].stride, (Bytes{8, 16}));  // 8 bytes, and 12 bytes rounded up to 16
  EXPECT_EQ(violations(outer), std::vector<std::string>{});
}

TEST(Plan, raises_the_alignment_of_records_but_not_of_nested_objects) {
  auto wide = object("Wide", {scalar("x")});
  wide.alignment = 32;
  const auto all = schema({wide, object("Outer", {scalar("a"), nested("wide", "test::Wide")})});
  const Records records(all, Space::host);
  EXPECT_EQ(records.of("test::Wide").alignment, (Bytes{32, 32}));
  EXPECT_EQ(records.of("test::Wide").bytes, (Bytes{4, 8}));
  EXPECT_EQ(records.of("test::Outer").slots[1].offset, (Bytes{4, 8}));
  EXPECT_EQ(records.of("test::Outer").alignment, (Bytes{4, 8}));
}

TEST(Plan, counts_four_stored_components_of_a_quaternion) {
  const auto turn = stored_on_cuda(rotation("R"), Encoding::native, true);
  EXPECT_EQ(stored_count(turn, Space::host), 9);
  EXPECT_EQ(stored_count(turn, Space::cuda), 4);
  EXPECT_EQ(element_bytes(turn, Space::cuda), (Bytes{4, 8}));
  const auto turns = object("Turns", {array(stored(rotation("R"), Encoding::snorm16, true), 3), scalar("x")});
  const Record record = plan_record(turns, Space::host, no_objects);
  EXPECT_EQ(record.slots[0].stride, (Bytes{8, 8}));
  EXPECT_EQ(record.slots[0].offset, (Bytes{4, 8}));
  EXPECT_EQ(record.bytes, (Bytes{28, 32}));
  EXPECT_EQ(runs(record)[0].count, 12);
}

TEST(Plan, gives_every_format_its_size_whatever_the_element_is) {
  const struct {
    Encoding encoding;
    Bytes of_real, of_double;
  } cases[] = {{Encoding::native, {4, 8}, {8, 8}},   {Encoding::float32, {4, 4}, {4, 4}},
               {Encoding::float64, {8, 8}, {8, 8}},  {Encoding::half, {2, 2}, {2, 2}},
               {Encoding::bfloat16, {2, 2}, {2, 2}}, {Encoding::snorm16, {2, 2}, {2, 2}}};
  for (const auto& [encoding, of_real, of_double] : cases) {
    EXPECT_EQ(element_bytes(stored(scalar("x"), encoding), Space::host), of_real);
    EXPECT_EQ(element_bytes(stored(scalar("x", Element::float64), encoding), Space::cuda), of_double);
    EXPECT_EQ(element_bytes(stored_on_cuda(scalar("x"), encoding), Space::host), (Bytes{4, 8}));
  }
}

TEST(Plan, differs_between_host_and_cuda_where_the_formats_differ) {
  const auto all = schema({object("Inner", {stored_on_cuda(scalar("x"), Encoding::half), scalar("i", Element::index)}),
                           object("Outer", {nested("inner", "test::Inner"), scalar("d", Element::float64)}),
                           object("Same", {stored(scalar("x"), Encoding::half), scalar("y")})});
  const Records host(all, Space::host), cuda(all, Space::cuda);
  EXPECT_EQ(host.of("test::Inner").bytes, (Bytes{8, 12}));
  EXPECT_EQ(cuda.of("test::Inner").bytes, (Bytes{6, 6}));
  EXPECT_EQ(cuda.of("test::Inner").slots[0].offset, (Bytes{4, 4}));
  EXPECT_EQ(cuda.of("test::Inner").natural_alignment, (Bytes{4, 4}));
  EXPECT_EQ(host.of("test::Outer").slots[0].stride, (Bytes{8, 16}));
  EXPECT_EQ(cuda.of("test::Outer").slots[0].stride, (Bytes{8, 8}));
  EXPECT_EQ(host.of("test::Outer").slots[1].offset, (Bytes{0, 16}));
  EXPECT_EQ(cuda.of("test::Outer").slots[1].offset, (Bytes{0, 0}));
  EXPECT_EQ(host.of("test::Same").bytes, cuda.of("test::Same").bytes);
}

// Up to five fields, each of 2, 4, 8 bytes or of Real, in every order; the last one has three elements.
TEST(Plan, of_mixed_sizes_has_no_gaps_whatever_their_order) {
  const std::array<Encoding, 4> encodings{Encoding::half, Encoding::float32, Encoding::float64, Encoding::native};
  for (unsigned count = 1; count <= 5; ++count) {
    for (unsigned combination = 0; combination < 1U << 2 * count; ++combination) {
      std::vector<model::Field> fields;
      Bytes sum, largest;
      for (unsigned f = 0; f < count; ++f) {
        const int rows = f + 1 == count ? 3 : 1;
        fields.push_back(
            stored(field("x" + std::to_string(f), Shape::vector, rows), encodings[combination >> 2 * f & 3U]));
        const Bytes element = element_bytes(fields.back(), Space::host);
        sum = sum + rows * element;
        largest.with_float = std::max(largest.with_float, element.with_float);
        largest.with_double = std::max(largest.with_double, element.with_double);
      }
      const auto mixed = object("Mixed", fields);
      const Record record = plan_record(mixed, Space::host, no_objects);
      ASSERT_EQ(record.bytes, sum) << count << " fields, combination " << combination;
      ASSERT_EQ(record.alignment, largest);
      ASSERT_EQ(violations(record), std::vector<std::string>{});
    }
  }
}

TEST(Plan, refuses_an_object_that_is_not_declared_before) {
  const auto unknown = schema({object("Outer", {nested("inner", "test::Inner")})});
  EXPECT_THROW((Records{unknown, Space::host}), std::invalid_argument);
}

TEST(Runs, name_every_field_in_order_of_declaration) {
  const auto all = schema({object("Point", {scalar("i", Element::int32), field("x", Shape::vector, 3)}),
                           object("Outer", {array(nested("points", "test::Point"), 2), nested("centre", "test::Point"),
                                            array(scalar("weights"), 5)})});
  const Records records(all, Space::host);
  std::vector<std::string> names;
  std::vector<int> counts;
  for (const auto& run : runs(records.of("test::Outer"))) {
    names.push_back(run.name());
    counts.push_back(run.count);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"points[0].i", "points[0].x", "points[1].i", "points[1].x", "centre.i",
                                             "centre.x", "weights"}));
  EXPECT_EQ(counts, (std::vector<int>{1, 3, 1, 3, 1, 3, 5}));
}

}  // namespace
}  // namespace physgen::plan
