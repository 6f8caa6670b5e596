// How many bytes a run will take, before anything of it is allocated: the solver's arrays, and the lists on the host.
#pragma once

#include "solver_bytes.h"

namespace physgen::truthcube {

[[nodiscard]] RunBytes bytes_of_run(const std::vector<LevelCounts>& levels, const fem::SolverSettings& settings,
                                    const RunArrays& arrays = {});

/// The bytes that a mesh of a level takes in the host's memory.
[[nodiscard]] std::int64_t bytes_of_mesh(const LevelCounts& level);

/// What a process that writes a step has of it, as vectors of all objects: positions, forces and stresses, the fields
/// that are drawn of them, and positions of all levels, twice, for a checkpoint.
[[nodiscard]] std::int64_t bytes_of_results(const std::vector<LevelCounts>& levels);

}  // namespace physgen::truthcube
