// `physgen usage`: which fields of which arrays the steps of programs read and write, as tables, as JSON, or compared
// with a JSON that is checked in.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace physgen::command {

struct UsageRequest {
  std::vector<std::string> files;  ///< declarations of scenes, or sources that give steps to a ProbeExecutor
  std::vector<std::string> flags;  ///< as of a compiler
  std::string side;                ///< "host", "device" or "both"; empty: both where there is a CUDA toolkit
  std::string json;                ///< file to write; empty: none
  std::string checked_in;          ///< file to compare with; empty: none
};

void describe_usage(CLI::App& app, UsageRequest& request);

/// @return exit status as run()'s: 1 where a file has errors, or the file that is checked in is stale
/// @throws FileError
int usage(const UsageRequest& request, std::ostream& out, std::ostream& err);

}  // namespace physgen::command
