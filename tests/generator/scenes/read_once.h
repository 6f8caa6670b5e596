// What scenes of the solver include, read once by the analysis, and by a compiler that is told to.
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "frontend/case.h"
#include "usage/analyse.h"

namespace physgen::test {

/// The parts of a list as CMake gives it.
inline std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, ':');)
    if (!part.empty()) parts.push_back(part);
  return parts;
}

/// What a command prints.
inline std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
  std::string text;
  char block[4096];
  while (const auto count = std::fread(block, 1, sizeof block, pipe.get())) text.append(block, count);
  return text;
}

class ReadOnce {
 public:
  /// @param headers as they are included. @param flags of all programs that are read
  ReadOnce(const std::vector<std::string>& headers, std::vector<std::string> flags) : flags_(std::move(flags)) {
    std::string text;
    for (const std::string& header : headers) text += "#include <" + header + ">\n";
    file_ = folder_.write("headers.h", text);
    flags_.insert(flags_.end(), {"-include", file_});
    usage::Diagnostics diagnostics;
    EXPECT_TRUE(usage::precompile(folder_ / "headers.pch", flags_, {usage::Side::host}, diagnostics))
        << diagnostics.text;
    flags_ = usage::with_precompiled(folder_ / "headers.pch", flags_);
  }

  /// The flags with which programs of the host are read.
  [[nodiscard]] const std::vector<std::string>& flags() const { return flags_; }
  /// A header that includes them. Beside it a compiler finds what it has read, by another suffix.
  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  Folder folder_;
  std::string file_;
  std::vector<std::string> flags_;
};

}  // namespace physgen::test
