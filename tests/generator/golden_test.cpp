// Whole texts against those in golden/: each .h is a schema, the .physgen.h and .python.cpp beside it what is expected
// from it. After an intended change, PHYSGEN_UPDATE_GOLDEN=1 writes them; golden_run_test.cpp compiles and runs them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "emit/emitter.h"
#include "frontend/frontend.h"

namespace physgen {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string read(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// Unified diff with three lines of context, as one hunk from the first difference to the last.
std::string difference(const std::string& expected_text, const std::string& found_text) {
  const auto expected = lines_of(expected_text), found = lines_of(found_text);
  std::size_t head = 0, tail = 0;
  const std::size_t shorter = std::min(expected.size(), found.size());
  while (head < shorter && expected[head] == found[head]) ++head;
  while (tail < shorter - head && expected[expected.size() - 1 - tail] == found[found.size() - 1 - tail]) ++tail;
  const std::size_t begin = head - std::min<std::size_t>(head, 3);
  const std::size_t context = std::min<std::size_t>(tail, 3);
  std::ostringstream out;
  out << "--- golden\n+++ generated\n@@ -" << begin + 1 << ',' << expected.size() - tail + context - begin << " +"
      << begin + 1 << ',' << found.size() - tail + context - begin << " @@\n";
  for (std::size_t i = begin; i < head; ++i) out << ' ' << expected[i] << '\n';
  for (std::size_t i = head; i < expected.size() - tail; ++i) out << '-' << expected[i] << '\n';
  for (std::size_t i = head; i < found.size() - tail; ++i) out << '+' << found[i] << '\n';
  for (std::size_t i = 0; i < context; ++i) out << ' ' << expected[expected.size() - tail + i] << '\n';
  return out.str();
}

struct Case {
  const char* schema;
  const char* emitter;
};
class Golden : public testing::TestWithParam<Case> {};

TEST_P(Golden, text_is_what_the_emitter_writes) {
  const std::filesystem::path folder = PHYSGEN_GOLDEN_DIR;
  const std::string name = GetParam().schema;
  const emit::Emitter& emitter = emit::emitter(GetParam().emitter);
  frontend::ParseOptions options;
  options.objections = emitter.objections;
  const auto parsed = frontend::parse(folder / (name + ".h"), options);
  ASSERT_TRUE(parsed.schema) << parsed.diagnostics;
  const std::string found = emitter.emit(*parsed.schema);
  const std::filesystem::path golden = folder / emit::file_of(emitter, parsed.schema->file);
  if (std::getenv("PHYSGEN_UPDATE_GOLDEN") != nullptr) {
    std::ofstream(golden, std::ios::binary) << found;
    GTEST_SKIP() << golden << " written";
  }
  const std::string expected = read(golden);
  EXPECT_TRUE(expected == found) << difference(expected, found);
}

INSTANTIATE_TEST_SUITE_P(Models, Golden,
                         testing::Values(Case{"materials", "cpp"}, Case{"everything", "cpp"},
                                         Case{"everything", "python"}),
                         [](const auto& info) { return info.param.schema + std::string("_") + info.param.emitter; });

}  // namespace
}  // namespace physgen
