// The command physgen as its users run it: a process with exit status, output and files.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "frontend/case.h"

namespace physgen::test {

inline std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class Command : public testing::Test {
 protected:
  struct Outcome {
    int status;
    std::string out, err;
  };

  /// Runs physgen with arguments as a shell reads them, in the test's folder.
  Outcome run(const std::string& arguments) const {
    const std::string line = "cd '" + (folder / ".") + "' && '" PHYSGEN_COMMAND "' " + arguments + " > '" +
                             (streams / "out") + "' 2> '" + (streams / "err") + "'";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(streams / "out"), text_of(streams / "err")};
  }

  [[nodiscard]] bool exists(const std::string& name) const { return std::filesystem::exists(folder / name); }

  [[nodiscard]] std::vector<std::string> files(const std::string& name) const {
    std::vector<std::string> result;
    for (const auto& entry : std::filesystem::directory_iterator(folder / name))
      result.push_back(entry.path().filename().string());
    std::sort(result.begin(), result.end());
    return result;
  }

  Folder folder, streams;
};

}  // namespace physgen::test
