// A run: steps of growing compression, what is printed of them, and what is written.
#pragma once

#include <string>

#include "options.h"
#include "outcome.h"

namespace physgen::truthcube {

/// @param command as it was typed, for run.json
/// @throw Error for files, meshes and memory
[[nodiscard]] Outcome run(Options options, const std::string& command);

}  // namespace physgen::truthcube
