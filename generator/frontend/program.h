// Parses C++ programs as compilers do: with the system's headers, the host's target and a compiler's flags. Schemas, in
// contrast, are parsed hermetically (frontend.h). Clang's types are in the interface: for other readers of programs.
#pragma once

#include <string>
#include <vector>

namespace clang {
class FrontendAction;
}

namespace physgen::frontend {

struct Program {
  std::string name;  ///< of the file that does not exist, for messages
  std::string text;
  std::vector<std::string> flags;  ///< as of a compiler: "-I", "include"; the runtime's folder needs none
  bool skip_bodies = false;        ///< of functions that are not constants: for readers of declarations alone
};

struct ProgramOutcome {
  bool parsed = false;                    ///< without errors
  std::string diagnostics;                ///< errors as Clang prints them; warnings are left to those who compile it
  std::vector<std::string> dependencies;  ///< files that were read, as they were named, without those of the system
};

/// A flag with a file behind it, which precompile() has written for the other flags.
inline constexpr const char* precompiled_flag = "-include-pch";

/// Runs `action` over a program. Flags that concern code generation or warnings may be among the flags.
[[nodiscard]] ProgramOutcome run(const Program& program, clang::FrontendAction& action);

/// Writes a precompiled header to `file`: what Clang knows behind the headers of the runtime with which units over
/// probes begin. Programs with the same flags that include these are parsed faster, to the same tree.
[[nodiscard]] ProgramOutcome precompile(const std::vector<std::string>& flags, const std::string& file);

}  // namespace physgen::frontend
