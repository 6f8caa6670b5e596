// The measurements of linear_solves, in the order of its flags.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "row.h"

namespace physgen::truthcube {

/// @param command as it was typed, for the rows
/// @param report called with each row once it is measured
/// @param say called with what a user should know, such as that a method is left out
/// @throw Error when a solver cannot be set up, K's state has no equilibrium, or a device fails
[[nodiscard]] std::vector<LinearRow> measure(const LinearOptions& options, const std::string& command,
                                             const std::function<void(const LinearRow&)>& report,
                                             const std::function<void(const std::string&)>& say);

}  // namespace physgen::truthcube
