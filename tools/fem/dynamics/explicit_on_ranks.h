// Explicit dynamics of an elastic body on several ranks.
#pragma once

#include <fem/solver/solvers/solver_on_ranks.h>
#include <physgen/distributed/options.h>
#include <physgen/distributed/ranks.h>

#include <memory>

namespace physgen::fem {

/// As make_explicit_solver(), on CPUs, each rank with its part of the mesh; bytes() are those of this rank.
/// @param level the same on all ranks, as loading and settings; that of a box may lack lists (cube_levels.h)
/// @throw Error as make_explicit_solver(), and for another device than the CPU
[[nodiscard]] std::unique_ptr<MotionOnRanks> make_explicit_solver_on_ranks(const Ranks& ranks, const MeshLevel& level,
                                                                           const Loading& loading,
                                                                           const DynamicSettings& settings,
                                                                           const DistributedOptions& options = {});

}  // namespace physgen::fem
