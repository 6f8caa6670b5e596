// linear_solves: one linear solve of the Truth Cube, by several methods, measured.
#include <truthcube/program.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "measure.h"

namespace physgen::truthcube {

namespace {

void print(const std::string& line) {
  std::printf("%s\n", line.c_str());
  std::fflush(stdout);
}

int run(const LinearOptions& options, const std::string& command) {
  print(table_head(options.copies));
  const std::vector<LinearRow> rows = measure(
      options, command, [&](const LinearRow& row) { print(table_line(row, options.copies)); },
      [](const std::string& note) { print("note: " + note); });
  if (!options.output.empty()) write_rows(options.output, rows);
  const auto converged = [](const LinearRow& row) {
    return row.measured.result.status == fem::LinearStatus::converged;
  };
  return std::ranges::all_of(rows, converged) ? 0 : 3;
}

}  // namespace

}  // namespace physgen::truthcube

int main(int count, char** words) {
  using namespace physgen::truthcube;
  return run_program("linear_solves", count, words, parse_linear, run);
}
