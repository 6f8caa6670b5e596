// The table of error against speed: rows of the sets of inputs.
#pragma once

#include <functional>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "measure/row.h"

namespace physgen::bench {

/// A finished row: its counters by name, and the command that runs its worst input again.
struct Finished {
  std::map<std::string, double> counters;
  std::string label;
};

/// The bytes of a row over the last-level cache, in the width of its column.
[[nodiscard]] std::string over_cache(const std::map<std::string, double>& counters);

/// Prints blocks by space and storage, then the worst inputs; nothing when no row of a set is among `finished`.
/// @param finished by name of the row
void print_errors_table(std::ostream& out, const std::vector<Row>& rows,
                        const std::map<std::string, Finished>& finished);

}  // namespace physgen::bench
