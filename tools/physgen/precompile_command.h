// `physgen precompile`: the headers with which programs of scenes begin, read once for many of `physgen scene`.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace physgen::command {

struct PrecompileRequest {
  std::string output;              ///< for the host's side; with .device behind it for the device's
  std::vector<std::string> flags;  ///< as of a compiler
  bool device = false;             ///< also for what programs do on a CUDA device
  std::string depfile, stamp;      ///< as of `physgen generate`; empty: none
};

void describe_precompile(CLI::App& app, PrecompileRequest& request);

/// @return exit status as run()'s: 1 where the headers cannot be compiled with these flags
/// @throws FileError
int precompile(const PrecompileRequest& request, std::ostream& err);

/// "scene.h: error: --device needs the headers of a CUDA toolkit ...", with a line's end. @param file what is read
[[nodiscard]] std::string without_toolkit(const std::string& file);

/// Describes --stamp and --depfile.
void describe_stamp(CLI::App& command, std::string& stamp, std::string& depfile);

}  // namespace physgen::command
