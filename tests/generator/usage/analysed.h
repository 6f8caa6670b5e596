// Analyses of the sources of this folder, which the tests of one process share, and their uses as texts.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include "usage/analyse.h"

namespace physgen::usage {

using Fields = std::set<std::string>;

inline const std::vector<std::string>& flags() {
  static const std::vector<std::string> words = [] {
    std::istringstream text(PHYSGEN_USAGE_FLAGS);
    return std::vector<std::string>(std::istream_iterator<std::string>(text), {});
  }();
  return words;
}

struct Analysis {
  std::optional<Usage> usage;
  Diagnostics diagnostics;
};

inline Analysis analysed(const std::string& name, const std::string& text, Side side = Side::host) {
  Analysis analysis;
  analysis.usage = analyse(name, text, flags(), side, analysis.diagnostics);
  return analysis;
}

/// The usage that is found in a file of tests/generator/usage. Each is analysed once for each side.
inline const Usage& usage_of(const std::string& file, Side side) {
  static std::map<std::pair<std::string, Side>, Usage> known;
  const auto [entry, is_new] = known.try_emplace({file, side});
  if (is_new) {
    std::ifstream in(PHYSGEN_USAGE_SOURCES "/" + file);
    const Analysis analysis = analysed(file, {std::istreambuf_iterator<char>(in), {}}, side);
    EXPECT_TRUE(analysis.usage) << analysis.diagnostics.text;
    EXPECT_EQ(analysis.diagnostics.text, "");
    if (analysis.usage) entry->second = *analysis.usage;
  }
  return entry->second;
}

inline Fields texts_of(const std::vector<FieldUse>& uses) {
  Fields result;
  for (const FieldUse& use : uses)
    result.insert(use.array + "." + use.field + (use.read ? " R" : " ") + (use.written ? "W" : "") +
                  (use.address_taken ? "&" : ""));
  return result;
}

inline const StepUse* step(const Usage& usage, const std::string& kernel) {
  for (const StepUse& step : usage.steps)
    if (step.kernel == kernel) return &step;
  return nullptr;
}

inline Fields fields_of(const Usage& usage, const std::string& kernel) {
  const StepUse* found = step(usage, kernel);
  EXPECT_NE(found, nullptr) << "there is no step " << kernel;
  return found == nullptr ? Fields() : texts_of(found->fields);
}

}  // namespace physgen::usage
