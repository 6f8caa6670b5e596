// What the stages of the set-up took, beside the bytes that they move at least.
#pragma once

#include <fem/mesh/stages.h>

#include "output/run_json.h"
#include "terminal.h"

namespace physgen::truthcube {

/// The stages for run.json. The time that belongs to none is the last of them, "other".
[[nodiscard]] std::vector<StageRecord> records_of(const fem::Stages& stages, double seconds);

/// Prints them: seconds, bytes, and their rate as a fraction of that of a copy of memory, which it measures.
void print_timings(const std::vector<StageRecord>& stages, const Terminal& terminal);

}  // namespace physgen::truthcube
