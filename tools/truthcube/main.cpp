// truthcube: the paper's silicone cube, or a mesh of your own, compressed quasistatically.
#include <omp.h>

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "error_text.h"
#include "options.h"
#include "run.h"

int main(int count, char** words) {
  std::vector<std::string> arguments(words + 1, words + count);
  physgen::truthcube::Options options;
  try {
    options = physgen::truthcube::parse(arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "truthcube: %s\ntruthcube --help lists what there is.\n",
                 physgen::truthcube::text_of(error).c_str());
    return 2;
  }
  if (!options.help.empty()) {
    std::printf("%s", options.help.c_str());
    return 0;
  }
  if (options.threads > 0) omp_set_num_threads(options.threads);
  std::string command = "truthcube";
  for (const std::string& word : arguments) command += " " + word;
  try {
    return static_cast<int>(physgen::truthcube::run(std::move(options), command));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "truthcube: %s\n", physgen::truthcube::text_of(error).c_str());
    return 1;
  }
}
