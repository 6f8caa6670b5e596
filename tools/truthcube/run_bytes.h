// How many bytes a run will take, before anything of it is allocated: the solver's arrays, and the lists on the host.
#pragma once

#include "solver_bytes.h"

namespace physgen::truthcube {

[[nodiscard]] RunBytes bytes_of_run(const std::vector<LevelCounts>& levels, const fem::SolverSettings& settings,
                                    const RunArrays& arrays = {});

/// The bytes that a mesh of a level takes in the host's memory.
[[nodiscard]] std::int64_t bytes_of_mesh(const LevelCounts& level);

}  // namespace physgen::truthcube
