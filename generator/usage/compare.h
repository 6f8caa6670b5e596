// Says in what a checked-in usage.json differs from what the analysis finds.
#pragma once

#include <string>
#include <vector>

#include "usage/usage.h"

namespace physgen::usage {

/// @return one line for each difference, without a line's end; none: they are the same
[[nodiscard]] std::vector<std::string> differences(const std::vector<Program>& checked_in,
                                                   const std::vector<Program>& found);

}  // namespace physgen::usage
