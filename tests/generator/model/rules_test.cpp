// The rules that every model keeps: sizes, formats and values of fields, nesting.
#include <gtest/gtest.h>

#include "rules_case.h"

namespace physgen::model {
namespace {

using test::issues;
using test::nested;
using test::of;
using test::scalar;
using test::stored_on_host;
using test::with;

TEST(Rules, refuse_sizes_that_do_not_fit_the_shape) {
  EXPECT_EQ(issues(with({of("x", Shape::rotation, 2, 2)})),
            "field 'x' has the type Rotation, but rows and cols are not 3");
  EXPECT_EQ(issues(with({of("x", Shape::symmetric, 3, 2)})),
            "field 'x' has the type Symmetric<3>, but rows and cols differ");
  EXPECT_EQ(issues(with({of("x", Shape::vector, 3, 3)})), "field 'x' has the type Vector<3>, but cols is not 1");
  EXPECT_EQ(issues(with({of("x", Shape::scalar, 2, 1)})), "field 'x' has the type Scalar, but rows and cols are not 1");
  Field rotation = of("x", Shape::rotation, 3, 3);
  rotation.element = Element::index;
  EXPECT_EQ(issues(with({rotation})), "field 'x' has the type Rotation, whose elements must be real");
}

TEST(Rules, refuse_nesting_that_does_not_end) {
  EXPECT_EQ(issues(with({nested("a", "m::A")})),
            "object 'A' contains itself; store an 'Index' of the other object instead");
  Schema both = with({nested("b", "m::B")});
  both.objects.push_back(both.objects[0]);
  both.objects[1].name = "B";
  both.objects[1].fields = {nested("a", "m::A")};
  EXPECT_EQ(
      issues(both),
      "field 'b' nests 'm::B', which is not declared before it; declare that object first (objects cannot nest each "
      "other)");
}

TEST(Rules, count_the_elements_of_nested_objects) {
  Schema schema = with({of("m", Shape::matrix, 128, 128)});
  schema.objects[0].fields[0].array_extent = 32;
  schema.objects.push_back(schema.objects[0]);
  schema.objects[1].name = "B";
  schema.objects[1].fields = {nested("a", "m::A")};
  schema.objects[1].fields[0].array_extent = 3;
  ASSERT_EQ(validate(schema).size(), 1u) << issues(schema);
  EXPECT_EQ(validate(schema)[0].place, (Place{false, 1, -1}));
}

TEST(Rules, refuse_formats_of_integers) {
  Field index = stored_on_host(scalar("i"), Encoding::half);
  for (const Element element : {Element::index, Element::int32, Element::int64, Element::uint64}) {
    index.element = element;
    EXPECT_EQ(issues(with({index})), "the elements of 'i' are integers, which have no other format; leave it out");
  }
  index.element = Element::boolean;
  EXPECT_EQ(issues(with({index})), "the elements of 'i' are bool, which has no other format; leave it out");
}

TEST(Rules, refuse_quaternions_of_what_is_no_rotation) {
  EXPECT_EQ(issues(with({stored_on_host(of("F", Shape::matrix, 3, 3), Encoding::native, true)})),
            "only a Rotation can be stored as a quaternion; 'F' is a Matrix<3, 3>");
  EXPECT_EQ(issues(with({stored_on_host(of("q", Shape::vector, 4, 1), Encoding::half, true)})),
            "only a Rotation can be stored as a quaternion; 'q' is a Vector<4>");
  EXPECT_EQ(issues(with({stored_on_host(of("R", Shape::rotation, 3, 3), Encoding::half, true)})), "");
}

TEST(Rules, refuse_equal_steps_without_a_range_to_take_them_over) {
  Field angle = stored_on_host(scalar("angle"), Encoding::snorm16);
  EXPECT_EQ(issues(with({angle})),
            "snorm16 has equal steps over a range, and 'angle' states none; add one, such as range(-1, 1)");
  angle.range = Range{2, 2};
  EXPECT_EQ(issues(with({angle})),
            "snorm16 has equal steps over a range of more than one value; widen the range of 'angle'");
  angle.range = Range{0, 3};
  EXPECT_EQ(issues(with({angle})), "");
  EXPECT_EQ(issues(with({stored_on_host(of("R", Shape::rotation, 3, 3), Encoding::snorm16)})), "") << "from -1 to 1";
}

TEST(Rules, refuse_steps_over_a_range_without_the_0_that_new_objects_hold) {
  Field angle = stored_on_host(scalar("angle"), Encoding::snorm16);
  angle.range = Range{1, 2};
  EXPECT_EQ(issues(with({angle})),
            "new objects hold 0 where no initial() is stated, which snorm16 over range(1, 2) does not hold; add "
            "initial(1) or another value of the range to 'angle', or widen the range to 0");
  angle.range = Range{-3, -2};
  EXPECT_EQ(issues(with({angle})),
            "new objects hold 0 where no initial() is stated, which snorm16 over range(-3, -2) does not hold; add "
            "initial(-2) or another value of the range to 'angle', or widen the range to 0");
  angle.initial = -2;
  EXPECT_EQ(issues(with({angle})), "");
  Field load = stored_on_host(scalar("load"), Encoding::half);
  load.range = Range{1, 2};
  EXPECT_EQ(issues(with({load})), "") << "half holds 0 whatever the range is";
}

TEST(Rules, refuse_an_initial_value_that_no_half_holds) {
  Field load = stored_on_host(scalar("load"), Encoding::half);
  load.initial = -65505;
  EXPECT_EQ(issues(with({load})),
            "initial(-65505) does not fit half, whose largest number is 65504; add range(...) to 'load', so that it is "
            "scaled");
  load.range = Range{-1e6, 0};
  EXPECT_EQ(issues(with({load})), "");
  load.range.reset();
  load.initial = 65504;
  EXPECT_EQ(issues(with({load})), "");
}

// The largest power of two that each format holds passes, the next one is refused.
TEST(Rules, refuse_ranges_and_initial_values_beyond_what_a_format_holds) {
  const auto issues_of = [](Encoding encoding, double size, Element element = Element::real) {
    Field field = stored_on_host(scalar("E"), encoding);
    field.element = element;
    field.range = Range{-size, size / 2};
    return issues(with({field}));
  };
  EXPECT_EQ(issues_of(Encoding::half, 0x1p115), "");
  EXPECT_EQ(issues_of(Encoding::half, 0x1p116),
            "the range of 'E' is beyond what this format holds, sizes up to 4.15e+34; choose float64");
  EXPECT_EQ(issues_of(Encoding::half, 0x1p-86), "");
  EXPECT_EQ(issues_of(Encoding::half, 0x1p-87),
            "the range of 'E' is beyond what this format holds, ranges that end above 1.3e-26; choose float64");
  for (const Encoding encoding : {Encoding::bfloat16, Encoding::float32, Encoding::snorm16}) {
    EXPECT_EQ(issues_of(encoding, 0x1p127), "");
    EXPECT_NE(issues_of(encoding, 0x1p128), "");
  }
  for (const Encoding encoding : {Encoding::native, Encoding::float64}) EXPECT_EQ(issues_of(encoding, 0x1p1000), "");
  EXPECT_EQ(issues_of(Encoding::snorm16, 0x1p1000, Element::float64), "") << "its steps are computed in double";
  Field initial = stored_on_host(scalar("E"), Encoding::bfloat16);
  initial.initial = -3.4e38;  // a float
  EXPECT_EQ(issues(with({initial})),
            "the initial value of 'E' is beyond what this format holds, sizes up to 3.38e+38; choose float64");
}

TEST(Rules, refuse_formats_of_nested_objects) {
  Schema schema = with({scalar("x")});
  schema.objects.push_back(schema.objects[0]);
  schema.objects[1].name = "B";
  schema.objects[1].fields = {stored_on_host(nested("a", "m::A"), Encoding::half)};
  EXPECT_EQ(issues(schema), "format() has no meaning for nested object 'a'; write it at the fields of 'm::A'");
}

TEST(Rules, place_an_issue_at_the_format_of_its_space) {
  Field field = stored_on_host(of("F", Shape::matrix, 3, 3), Encoding::native, true);
  EXPECT_EQ(validate(with({field})).at(0).aspect, Aspect::host_format);
  std::swap(field.host_format, field.cuda_format);
  EXPECT_EQ(validate(with({field})).at(0).aspect, Aspect::cuda_format);
}

TEST(Rules, refuse_initial_values_that_become_0_as_floats) {
  Field field = scalar("a");
  field.initial = -1e-60;
  for (const Element element : {Element::real, Element::float32}) {
    field.element = element;
    EXPECT_EQ(issues(with({field})),
              "initial(-1e-60) is 0 as a float, as the elements of 'a' are or can be; write 0 or a size from 1.5e-45 "
              "on, or declare it double");
  }
  field.element = Element::float64;
  EXPECT_EQ(issues(with({field})), "");
  field.element = Element::real;
  for (const double held : {0.0, -0.0, 1.5e-45, -1e-40}) {
    field.initial = held;
    EXPECT_EQ(issues(with({field})), "");
  }
}

TEST(Rules, refuse_a_schema_without_objects) { EXPECT_EQ(validate(Schema{}).size(), 1u); }

}  // namespace
}  // namespace physgen::model
