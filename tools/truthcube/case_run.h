// A run of a case: from rest, load after load, with its reactions, extremes and probes.
#pragma once

#include <fem/mesh/stages.h>

#include <string>

#include "options.h"
#include "outcome.h"
#include "ranks_of_run.h"

namespace physgen::truthcube {

/// @param command as it was typed @param stages of the set-up, which are recorded
/// @throw Error for a mesh that is not sound, loads that no body can be in, or a file or memory that fails
[[nodiscard]] Outcome run_case(Options options, const std::string& command, const fem::Stages& stages,
                               RanksOfRun& ranks);

}  // namespace physgen::truthcube
