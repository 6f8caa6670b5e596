// Finds what a program's steps read and write, with Clang: a translation unit that gives steps to a ProbeExecutor is
// parsed as a compiler parses it, and the instantiated functions are followed from each step to the decode, encode and
// address of probes. Only readers get to see Clang's tree.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "usage/usage.h"

namespace clang {
class ASTContext;
}

namespace physgen::usage {

/// Looks at a parsed unit for itself. @param folders in which #include looks
using Reader = std::function<void(clang::ASTContext& context, const std::vector<std::string>& folders)>;

/// Text of C++ that a unit goes on with, for what steps are found to do in its text before. Empty: it ends there.
using Rest = std::function<std::string(const Usage& found)>;

/// Which functions a compiler sees: those of the CPU, or of a CUDA device.
enum class Side { host, device };

struct Diagnostics {
  std::string text;                       ///< as Clang prints them, with source line and caret
  std::vector<std::string> dependencies;  ///< files that were read, without the system's
  double headers_seconds = 0;             ///< until the last header had been parsed
  double seconds = 0;                     ///< of the whole analysis, without what rest() takes
};

/// @param name of the source, for messages; its folder is where its #include "..." look first
/// @param source the text, which need not be a file
/// @param flags as of a compiler
/// @param reader is called when the unit has been read without errors
/// @param rest of a unit that ends with namespace physgen_probe_unit: is asked for what follows, which runs the same
///        program over other arrays to be compared
/// @return none: the source has errors. All accesses that any instantiated code can make are in the result, those
///         that no step leads to as unattributed
[[nodiscard]] std::optional<Usage> analyse(const std::string& name, const std::string& source,
                                           const std::vector<std::string>& flags, Side side, Diagnostics& diagnostics,
                                           const Reader& reader = {}, const Rest& rest = {});

/// The file of a side: `file` of the host's, `file`.device of the other.
[[nodiscard]] std::string precompiled(const std::string& file, Side side);

/// Writes a precompiled header of what units begin with, for each side. What is found in programs stays the same:
/// functions of these headers are the libraries', and none of them names a probe of a unit.
/// @param diagnostics gets the files that were read, and errors
/// @return whether there are no errors
[[nodiscard]] bool precompile(const std::string& file, const std::vector<std::string>& flags,
                              const std::vector<Side>& sides, Diagnostics& diagnostics);

/// The flags with which programs are read by means of precompile()'s files, on any of its sides.
[[nodiscard]] std::vector<std::string> with_precompiled(const std::string& file, std::vector<std::string> flags);

/// "stresses, host: analysed in 3.10 s, of which its headers took 2.40 s to parse (1.29 times as long)", with a line's
/// end.
[[nodiscard]] std::string text_of_time(const std::string& program, Side side, const Diagnostics& diagnostics);

/// Whether there is a CUDA toolkit for the device's side.
[[nodiscard]] bool has_device_side();

}  // namespace physgen::usage
