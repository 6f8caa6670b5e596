// The frame of truthcube's programs: they read the command line, and turn errors into text and an exit status.
#pragma once

#include <omp.h>

#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace physgen::truthcube {

/// The text of an error for a user: without the library's name before it.
[[nodiscard]] inline std::string text_of(const std::exception& error) {
  const std::string text = error.what(), prefix = "physgen: ";
  return text.starts_with(prefix) ? text.substr(prefix.size()) : text;
}

/// @param parse makes options, with `help` and `threads`, of the words behind the program's name
/// @param run takes the options and the command as it was typed, and gives the exit status
/// @return the exit status: 2 for a command line that is not understood, 1 where run() throws
template <class Parse, class Run>
[[nodiscard]] int run_program(const std::string& name, int count, char** words, const Parse& parse, const Run& run) {
  const std::vector<std::string> arguments(words + 1, words + count);
  decltype(parse(arguments)) options;
  try {
    options = parse(arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n%s --help lists what there is.\n", name.c_str(), text_of(error).c_str(),
                 name.c_str());
    return 2;
  }
  if (!options.help.empty()) {
    std::printf("%s", options.help.c_str());
    return 0;
  }
  if (options.threads > 0) omp_set_num_threads(options.threads);
  std::string command = name;
  for (const std::string& word : arguments) command += " " + word;
  try {
    return run(std::move(options), command);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), text_of(error).c_str());
    return 1;
  }
}

}  // namespace physgen::truthcube
