// A run: steps of growing compression, what is printed of them, and what is written.
#pragma once

#include <physgen/distributed/ranks.h>

#include <string>

#include "options.h"
#include "outcome.h"

namespace physgen::truthcube {

/// @param command as it was typed, for run.json
/// @throw Error for files, meshes and memory; and for what several ranks do not have
[[nodiscard]] Outcome run(Options options, const std::string& command, const Ranks& ranks);

}  // namespace physgen::truthcube
