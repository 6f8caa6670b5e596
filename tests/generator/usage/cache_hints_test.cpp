// Loads and stores of CUDA that take an address: of one element they are uses of its field, and hide nothing.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "usage/analyse.h"

namespace physgen::usage {
namespace {

using Texts = std::set<std::string>;

Texts texts_of(const StepUse& step) {
  Texts result;
  for (const FieldUse& use : step.fields)
    result.insert(use.array + "." + use.field + (use.read ? " R" : " ") + (use.written ? "W" : "") +
                  (use.address_taken ? "&" : ""));
  return result;
}

TEST(UsageOfCacheHints, is_of_the_element_whose_address_they_take_and_what_lies_behind_it_is_not_followed) {
  if (!has_device_side()) GTEST_SKIP() << "there is no CUDA toolkit";
  const std::string file = PHYSGEN_USAGE_SOURCES "/cache_hints.cpp";
  std::ifstream in(file);
  const std::string source((std::istreambuf_iterator<char>(in)), {});
  std::istringstream words(PHYSGEN_USAGE_FLAGS);
  Diagnostics diagnostics;
  const auto usage = analyse(file, source, {std::istream_iterator<std::string>(words), {}}, Side::device, diagnostics);
  ASSERT_TRUE(usage) << diagnostics.text;
  ASSERT_EQ(usage->steps.size(), 2U);
  EXPECT_EQ(usage->steps[0].kernel, "cache_hints::FurtherThanTheElement");
  EXPECT_EQ(texts_of(usage->steps[1]), (Texts{"loaded.volume R&", "stored.x1111 RW&", "stored.x2222 RW&"}));

  std::set<int> unknown, expected;
  for (const UnknownUse& use : usage->unknown) unknown.insert(use.place.line);
  std::istringstream lines(source);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number)
    if (line.ends_with("  // not followed")) expected.insert(number);
  EXPECT_EQ(unknown, expected);
  EXPECT_EQ(expected.size(), 2U);
}

}  // namespace
}  // namespace physgen::usage
