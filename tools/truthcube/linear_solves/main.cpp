// linear_solves: one linear solve of the Truth Cube, by several methods, measured.
#include <omp.h>
#include <truthcube/error_text.h>

#include <algorithm>
#include <cstdio>
#include <exception>
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
  const std::vector<std::string> arguments(words + 1, words + count);
  physgen::truthcube::LinearOptions options;
  try {
    options = physgen::truthcube::parse_linear(arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "linear_solves: %s\nlinear_solves --help lists what there is.\n",
                 physgen::truthcube::text_of(error).c_str());
    return 2;
  }
  if (!options.help.empty()) {
    std::printf("%s", options.help.c_str());
    return 0;
  }
  if (options.threads > 0) omp_set_num_threads(options.threads);
  std::string command = "linear_solves";
  for (const std::string& word : arguments) command += " " + word;
  try {
    return physgen::truthcube::run(options, command);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "linear_solves: %s\n", physgen::truthcube::text_of(error).c_str());
    return 1;
  }
}
