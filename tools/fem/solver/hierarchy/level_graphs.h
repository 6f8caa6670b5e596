// The graphs of the levels that a solver uses, which a program may have made.
#pragma once

#include <fem/solver/hierarchy/hierarchy.h>
#include <fem/solver/settings.h>

#include <span>
#include <vector>

namespace physgen::fem {

/// The graphs of the levels that a solver uses, the first of those it is given, as make_counted_graphs() makes them.
/// Takes SolverSettings::graphs, if there are any.
/// @throw Error as make_level_graphs(), and when the graphs are not those of these levels
[[nodiscard]] std::vector<LevelGraph> graphs_in_use(std::span<const MeshLevel> used, const SolverSettings& settings);

}  // namespace physgen::fem
