// The command line: the program's own flags. Flags of Google Benchmark pass through.
#pragma once

#include <string>
#include <vector>

#include "measure/registry.h"

namespace physgen::bench {

struct Options {
  std::string group = "kernels";
  int threads = 0;  ///< of the CPU's rows, see physgen::set_threads()
  Sizes sizes;
  std::string filter;     ///< a regular expression: the rows to run
  bool filtered = false;  ///< by the user
  bool table = false;     ///< print the table
  bool list = false;      ///< names only
  bool json = false;      ///< the display, too, is Google Benchmark's JSON or CSV: no table, no progress
  bool to_file = false;
  std::string help;                          ///< what to print where help was asked for
  std::vector<std::string> benchmark_flags;  ///< what Google Benchmark gets
};

/// @throw Error for a group or flag that neither this program nor Google Benchmark knows, or a value out of range
[[nodiscard]] Options parse(const std::vector<std::string>& arguments);

/// The rows whose names the filter finds or, where it begins with -, does not find: Google Benchmark's rule.
/// @throw Error where the filter is no regular expression
[[nodiscard]] std::vector<Row> filtered(std::vector<Row> rows, const std::string& filter);

}  // namespace physgen::bench
