// A run: steps of growing compression, what is printed of them, and what is written.
#pragma once

#include <string>

#include "options.h"

namespace physgen::truthcube {

/// Ends of a run, as exit statuses.
enum class Outcome { done = 0, not_converged = 3, interrupted = 130 };

/// @param command as it was typed, for run.json
/// @throw Error for files, meshes and memory
[[nodiscard]] Outcome run(Options options, const std::string& command);

}  // namespace physgen::truthcube
