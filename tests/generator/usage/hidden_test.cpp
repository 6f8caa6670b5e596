// Facts that kernels may hide from probes: the places at which a program depends on how fields are stored, and those
// that nobody can follow, are the lines of usage/hidden.h that say so.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "scenes/analysis.h"
#include "scenes/liveness.h"
#include "scenes/read.h"

namespace physgen::usage {
namespace {

using Lines = std::set<int>;

const std::string& file() {
  static const std::string name = PHYSGEN_USAGE_SOURCES "/hidden.h";
  return name;
}

Lines lines_that_say(const std::string& word) {
  std::ifstream in(file());
  Lines result;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number)
    if (const auto comment = line.rfind("  // "); comment != std::string::npos && comment > 0 &&
                                                  line.find_first_not_of(' ') < comment &&
                                                  line.find(word, comment) != std::string::npos)
      result.insert(number);
  return result;
}

TEST(UsageOfHiddenUses, is_found_at_each_line_that_hides_one_and_at_no_other) {
  std::istringstream text(PHYSGEN_USAGE_FLAGS);
  const std::vector<std::string> flags(std::istream_iterator<std::string>(text), {});
  const auto declaration = scenes::read(file(), flags);
  ASSERT_TRUE(declaration.scene) << declaration.diagnostics;
  const auto analysis = scenes::analyse(*declaration.scene, file(), flags, {Side::host});
  const auto& usage = analysis.usage;
  ASSERT_TRUE(usage) << analysis.diagnostics[0].text;
  Lines dependent, unknown;
  for (const Dependence& dependence : usage->dependences) dependent.insert(dependence.place.line);
  for (const UnknownUse& use : usage->unknown) unknown.insert(use.place.line);
  EXPECT_EQ(dependent, lines_that_say("depends"));
  EXPECT_EQ(unknown, lines_that_say("not followed"));
  EXPECT_GE(dependent.size(), 25U);
  EXPECT_GE(unknown.size(), 8U);

  const auto liveness = scenes::find_liveness(*declaration.scene, *usage);
  Lines errors;
  for (const scenes::Issue& issue : liveness.errors) errors.insert(issue.place.line);
  dependent.insert(unknown.begin(), unknown.end());
  EXPECT_EQ(errors, dependent) << "each is an error of the scene";
}

}  // namespace
}  // namespace physgen::usage
