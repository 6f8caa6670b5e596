// Bytes of the solver's arrays, from the records of the generated types.
#pragma once

#include <fem/solver/settings.h>

#include <cstdint>
#include <vector>

#include "sizes.h"

namespace physgen::truthcube {

/// All of RunBytes but what lies in lists.
[[nodiscard]] RunBytes solver_bytes(const std::vector<LevelCounts>& levels, const fem::SolverSettings& settings,
                                    const RunArrays& arrays);

}  // namespace physgen::truthcube
