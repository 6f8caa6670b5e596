// A run that moves in time: the plate goes to its compression, and states are printed and written on the way.
#pragma once

#include <fem/solver/dynamic_solver.h>

#include <memory>
#include <vector>

#include "options.h"
#include "outcome.h"
#include "output/run_json.h"
#include "ranks_of_run.h"
#include "run_files.h"
#include "scene.h"
#include "terminal.h"

namespace physgen::truthcube {

/// The solver of a scene that moves.
/// @throw Error when a time step is longer than what is stable, and as the solvers' makers do
[[nodiscard]] std::unique_ptr<fem::DynamicSolver> make_dynamic_solver(const Options& options, const Scene& scene,
                                                                      RanksOfRun& ranks);

/// The travel of the plate over the height at a time: 0 to `compression` in the first half of the duration, with
/// velocity and acceleration 0 at both ends.
[[nodiscard]] double compression_at(double time, double duration, double compression);

/// Moves a body and writes its states. Ctrl-C ends it after the time step under way; a second one ends the process.
/// @param record gets an entry for each state
/// @throw Error when a file cannot be written
[[nodiscard]] Outcome run_motion(const Options& options, const Scene& scene, fem::DynamicSolver& solver,
                                 RunFiles& files, RunRecord& record, const Terminal& terminal, const RanksOfRun& ranks);

}  // namespace physgen::truthcube
