// groups.csv and probes.csv of a case: a row for each group, or probe, of each step.
#pragma once

#include <truthcube/output/case_state.h>

#include <filesystem>
#include <span>

namespace physgen::truthcube {

/// Writes both into a folder, in the place of old ones; the second where there are probes.
/// @throws Error when a file cannot be written
void write_case_tables(const std::filesystem::path& folder, std::span<const CaseState> steps);

}  // namespace physgen::truthcube
