// Everything that the frontend refuses, with line, column and text; each table is one kind of mistake. The texts are
// compared as beginnings, because the ends of Clang's own differ between its versions.
#include <gtest/gtest.h>

#include "cases_constructs.h"
#include "cases_numbers.h"
#include "cases_options.h"
#include "cases_types.h"

namespace physgen::test {
namespace {

class Diagnostics : public testing::TestWithParam<DiagnosticCase> {};

TEST_P(Diagnostics, reports) {
  const auto result = parse_text(schema_of(GetParam().schema));
  EXPECT_FALSE(result.schema.has_value());
  const auto found = headlines(result.diagnostics);
  const auto& expected = GetParam().expected;
  ASSERT_EQ(found.size(), expected.size()) << result.diagnostics;
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_EQ(found[i].substr(0, expected[i].size()), expected[i]) << result.diagnostics;
}

std::string name_of(const testing::TestParamInfo<DiagnosticCase>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Constructs, Diagnostics, testing::ValuesIn(constructs_cases), name_of);
INSTANTIATE_TEST_SUITE_P(Types, Diagnostics, testing::ValuesIn(types_cases), name_of);
INSTANTIATE_TEST_SUITE_P(Options, Diagnostics, testing::ValuesIn(options_cases), name_of);
INSTANTIATE_TEST_SUITE_P(Numbers, Diagnostics, testing::ValuesIn(numbers_cases), name_of);

}  // namespace
}  // namespace physgen::test
