// The program's own flags. Flags of Google Benchmark pass through.
#pragma once

#include <physgen/config.h>

#include <string>
#include <vector>

namespace physgen::bench {

/// Which rows there are: the first word of the command line, or those of the kernels.
enum class Group { kernels, errors, storage, conversions, gathers, forces, growth, reduce };

struct Options {
  Group group = Group::kernels;
  int threads = 0;  ///< OpenMP threads of the CPU's rows; parse() fills in the default
  index_t host_objects = 1048576;
  index_t cuda_objects = 8388608;
  index_t set_objects = 1048576;  ///< of rows of the sets, on both
  bool objects_given = false;     ///< by --objects
  bool table = false;             ///< print the table
  bool list = false;              ///< names only
  bool json = false;              ///< the display, too, is Google Benchmark's JSON or CSV: no table, no progress
  std::vector<std::string> benchmark_flags;  ///< what Google Benchmark gets
};

extern const char* const help_text;

/// @throw Error for a flag that neither this program nor Google Benchmark knows, or a value out of range
[[nodiscard]] Options parse(int argc, const char* const* argv);

}  // namespace physgen::bench
