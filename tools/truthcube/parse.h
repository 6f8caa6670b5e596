// The command line of truthcube.
#pragma once

#include <string>
#include <vector>

#include "options.h"

namespace physgen::truthcube {

/// The layout that the build has for all arrays: "schema", or one for all, such as "aos".
[[nodiscard]] std::string built_layout();

/// @throw Error for a flag or value that does not exist, with the nearest name, or is out of range
[[nodiscard]] Options parse(const std::vector<std::string>& arguments);

}  // namespace physgen::truthcube
