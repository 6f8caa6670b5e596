// Numbers of options that reach them as they are written, or as an explicit cast makes them, are accepted; others are
// in cases_numbers.h.
#include <gtest/gtest.h>

#include "case.h"

namespace physgen::test {
namespace {

TEST(ChangedNumbers, accepts_exact_divisions_casts_named_integers_and_rounded_decimals) {
  const auto result = parse_text(schema_of(
      "constexpr int three = 7 / 2; enum Count { five = 5 };\n"
      "struct PHYSGEN_OBJECT(align(8 * 2), layout(host, aosoa(1 << 4))) A {\n"
      "  PHYSGEN(range(0, 6 / 2), initial(int(7 / 3))) Scalar x;\n  PHYSGEN(initial(three)) Index y;\n"
      "  PHYSGEN(initial(five)) Index z;\n  PHYSGEN(range(-1, 1), initial(0.1F)) Scalar u;\n"
      "  PHYSGEN(initial(true)) Scalar v;\n  PHYSGEN(range(1.0 / 3, 0.1L * 10)) Scalar w;\n"
      "  PHYSGEN(initial(three ? 1 << 7 / 2 : 0)) Scalar t;\n  PHYSGEN(initial(0.5 && five)) Scalar s;\n};\n"));
  ASSERT_TRUE(result.schema.has_value()) << result.diagnostics;
  EXPECT_EQ(result.diagnostics, "");
  const auto& fields = result.schema->objects.at(0).fields;
  EXPECT_EQ(fields.at(0).initial, 2);
  EXPECT_EQ(fields.at(1).initial, 3);
}

TEST(ChangedNumbers, warns_of_a_backslash_that_makes_the_next_field_part_of_a_comment) {
  const auto result = parse_text(schema_of(object("Scalar x;  // in C:\\\n  Scalar y;")));
  EXPECT_NE(result.diagnostics.find("4:22: warning: multi-line // comment"), std::string::npos) << result.diagnostics;
}

}  // namespace
}  // namespace physgen::test
