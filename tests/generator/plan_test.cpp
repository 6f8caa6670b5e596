// Plans of records: where fields lie, and that the proof refuses every record that is wrong.
#include "plan/plan.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "models.h"
#include "plan/proof.h"

namespace physgen::plan {
namespace {

using model::Element;
using model::Shape;
using test::array;
using test::field;
using test::nested;
using test::object;
using test::scalar;
using test::schema;

const Record& no_objects(const std::string& name) { throw std::invalid_argument(name); }

TEST(Plan, packs_real_fields_in_order_of_declaration) {
  const auto svd = object("DeformationSvd", {field("U", Shape::rotation, 3, 3), field("V", Shape::rotation, 3, 3),
                                             field("s", Shape::diagonal, 3, 3)});
  const Record record = plan_record(svd, no_objects);
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
  const Record record = plan_record(mixed, no_objects);
  EXPECT_EQ(record.order, (std::vector<int>{2, 5, 1, 4, 0, 3}));
  EXPECT_EQ(record.slots[5].offset, (Bytes{8, 8}));    // e behind d
  EXPECT_EQ(record.slots[1].offset, (Bytes{16, 16}));  // then Real
  EXPECT_EQ(record.slots[4].offset, (Bytes{20, 24}));
  EXPECT_EQ(record.slots[0].offset, (Bytes{24, 32}));  // then 4 bytes
  EXPECT_EQ(record.slots[3].offset, (Bytes{28, 36}));
  EXPECT_EQ(record.bytes, (Bytes{32, 40}));
  EXPECT_EQ(record.alignment, (Bytes{8, 8}));
  EXPECT_EQ(violations(record), std::vector<std::string>{});
}

TEST(Plan, counts_the_stored_elements_of_every_structure) {
  const auto all = object(
      "All", {field("symmetric", Shape::symmetric, 3, 3), field("diagonal", Shape::diagonal, 3, 3),
              field("skew", Shape::skew, 3, 3), field("rotation", Shape::rotation, 3, 3),
              field("matrix", Shape::matrix, 2, 5), array(field("vectors", Shape::vector, 3), 4), scalar("end")});
  const Record record = plan_record(all, no_objects);
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
  const Records records(all);
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
  const Records records(all);
  const Record& outer = records.of("test::Outer");
  EXPECT_EQ(outer.order, (std::vector<int>{3, 1, 2, 0}));
  EXPECT_EQ(outer.slots[2].offset, (Bytes{12, 16}));
  EXPECT_EQ(outer.slots[2].stride, (Bytes{8, 16}));  // 8 bytes, and 12 bytes rounded up to 16
  EXPECT_EQ(violations(outer), std::vector<std::string>{});
}

TEST(Plan, raises_the_alignment_of_records_but_not_of_nested_objects) {
  auto wide = object("Wide", {scalar("x")});
  wide.alignment = 32;
  const auto all = schema({wide, object("Outer", {scalar("a"), nested("wide", "test::Wide")})});
  const Records records(all);
  EXPECT_EQ(records.of("test::Wide").alignment, (Bytes{32, 32}));
  EXPECT_EQ(records.of("test::Wide").bytes, (Bytes{4, 8}));
  EXPECT_EQ(records.of("test::Outer").slots[1].offset, (Bytes{4, 8}));
  EXPECT_EQ(records.of("test::Outer").alignment, (Bytes{4, 8}));
}

TEST(Plan, refuses_an_object_that_is_not_declared_before) {
  const auto unknown = schema({object("Outer", {nested("inner", "test::Inner")})});
  EXPECT_THROW(Records{unknown}, std::invalid_argument);
}

TEST(Runs, name_every_field_in_order_of_declaration) {
  const auto all = schema({object("Point", {scalar("i", Element::int32), field("x", Shape::vector, 3)}),
                           object("Outer", {array(nested("points", "test::Point"), 2), nested("centre", "test::Point"),
                                            array(scalar("weights"), 5)})});
  const Records records(all);
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

class Fault : public testing::Test {
 protected:
  // The first complaint about the record as it has been changed.
  [[nodiscard]] std::string first() const {
    const auto found = violations(record);
    return found.empty() ? "none" : found.front();
  }
  model::Object declared = object("A", {scalar("d", Element::float64), field("v", Shape::vector, 3), scalar("x")});
  Record record = plan_record(declared, no_objects);
};

TEST_F(Fault, none_is_found_in_a_sound_record) { EXPECT_EQ(first(), "none"); }

TEST_F(Fault, an_overlap_is_refused_with_both_names) {
  record.slots[2].offset.with_float -= 4;
  EXPECT_EQ(first(), "test::A with Real = float: v and x share byte 16");
}

TEST_F(Fault, an_overlap_in_one_precision_only_is_refused) {
  record.slots[2].offset.with_double = 8;
  EXPECT_EQ(first(), "test::A with Real = double: v and x share byte 8");
}

TEST_F(Fault, a_misaligned_element_is_refused) {
  record.bytes = {100, 100};
  record.slots[2].offset.with_double += 4;
  EXPECT_EQ(first(), "test::A with Real = double: x at byte 36 is not aligned to its 8 bytes");
}

TEST_F(Fault, an_element_behind_the_end_is_refused) {
  record.bytes.with_float -= 4;
  EXPECT_EQ(first(), "test::A with Real = float: x at byte 20 ends at byte 24 of a record of 20");
}

TEST_F(Fault, an_element_before_the_beginning_is_refused) {
  record.slots[0].offset = {-8, -8};
  EXPECT_NE(first(), "none");
}

TEST_F(Fault, records_aligned_to_less_than_an_element_are_refused) {
  record.alignment.with_float = 4;
  EXPECT_EQ(first(), "test::A with Real = float: records are aligned to 4 bytes, d needs 8");
}

TEST_F(Fault, a_wrong_stride_of_nested_objects_is_refused) {
  const auto outer = object("Outer", {array(nested("a", "test::A"), 3)});
  Record wrong = plan_record(outer, [this](const std::string&) -> const Record& { return record; });
  ASSERT_EQ(violations(wrong), std::vector<std::string>{});
  wrong.slots[0].stride.with_float -= 8;
  ASSERT_FALSE(violations(wrong).empty());
  EXPECT_EQ(violations(wrong).front(), "test::Outer with Real = float: a[0].v and a[1].d share byte 16");
}

TEST(Plan, of_random_objects_is_sound) {
  const unsigned seed = 20240917;
  RecordProperty("seed", static_cast<int>(seed));
  std::mt19937 random(seed);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  constexpr Element elements[] = {Element::real, Element::index, Element::float32, Element::float64, Element::int32};
  model::Schema all = schema({});
  for (int o = 0; o < 200; ++o) {
    std::vector<model::Field> fields;
    for (int f = 1 + below(8); f > 0; --f) {
      const std::string name = "f" + std::to_string(f);
      model::Field made = o > 0 && below(4) == 0
                              ? nested(name, "test::O" + std::to_string(o - 1 - below(std::min(o, 3))))
                              : field(name, Shape::matrix, 1 + below(4), 1 + below(4), elements[below(5)]);
      if (below(3) == 0) made.array_extent = 1 + below(2);
      fields.push_back(made);
    }
    all.objects.push_back(object("O" + std::to_string(o), fields));
    if (o % 10 == 0) all.objects.back().fields = {scalar("d", elements[below(5)])};  // keeps nesting from exploding
  }
  const Records records(all);
  for (const model::Object& o : all.objects) {
    ASSERT_EQ(violations(records.of(o.qualified_name())), std::vector<std::string>{}) << "seed " << seed;
  }
}

}  // namespace
}  // namespace physgen::plan
