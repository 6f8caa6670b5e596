// The solvers on several ranks that a build has.
#pragma once

#include <fem/solver/scene_rows.h>
#include <fem/solver/solvers/solver_on_ranks.h>
#include <physgen/distributed/options.h>
#include <physgen/distributed/ranks.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace physgen::fem {

/// Equilibria of one of the scenes of make_scene_solver() by name, or of "everything", as of make_solver(); on CUDA of
/// quasistatic, where each rank takes a device and sums are formed in a fixed order, so that they have the bits of one
/// rank. bytes() are those of this rank.
/// @param levels the same on all ranks, as loading and settings. Of a box a rank makes the lists of its part alone, and
/// those of levels that are cut may be missing (cube_levels.h); of other meshes it has those of the whole for a while
/// @param replicated as levels_that_are_cut() takes it
/// @throw Error as make_scene_solver() or make_solver(); of everything for what of it one process alone has; and for
/// supports along axes of their own, for multigrid over one level that is inverted as a whole, which one process has,
/// and where ranks would share a GPU
[[nodiscard]] std::unique_ptr<SolverOnRanks> make_solver_on_ranks(
    const Ranks& ranks, const std::string& scene, const std::vector<MeshLevel>& levels, const Loading& loading,
    const SolverSettings& settings, std::optional<index_t> replicated = {}, const DistributedOptions& options = {});

/// Motion of the scene implicit_dynamics on CPUs, as of make_scene_implicit_solver(). The rest as of
/// make_solver_on_ranks().
[[nodiscard]] std::unique_ptr<MotionOnRanks> make_implicit_solver_on_ranks(
    const Ranks& ranks, const std::vector<MeshLevel>& levels, const Loading& loading, const DynamicSettings& settings,
    std::optional<index_t> replicated = {}, const DistributedOptions& options = {});

/// Linear elastic bodies on CPUs, as of make_linear_solver(), without the preconditioner Schwarz and levels of a
/// background grid. The rest as of make_solver_on_ranks().
[[nodiscard]] std::unique_ptr<SolverOnRanks> make_linear_solver_on_ranks(
    const Ranks& ranks, const std::vector<MeshLevel>& levels, const Loading& loading, const SolverSettings& settings,
    std::optional<index_t> replicated = {}, const DistributedOptions& options = {});

/// That of each scene is compiled as one file: see scene_on_ranks.in. @pre nothing is asked for that it has not
using MakeSolverOnRanks = std::unique_ptr<SolverOnRanks>(const Ranks& ranks, const std::vector<MeshLevel>& levels,
                                                         const Loading& loading, const SolverSettings& settings,
                                                         std::optional<index_t> replicated,
                                                         const DistributedOptions& options);
#define PHYSGEN_DECLARE_ON_RANKS(scene, ...) MakeSolverOnRanks make_##scene##_on_ranks;
PHYSGEN_EQUILIBRIUM_SCENES(PHYSGEN_DECLARE_ON_RANKS)
MakeSolverOnRanks make_everything_on_ranks;
#undef PHYSGEN_DECLARE_ON_RANKS
MakeSolverOnRanks make_linear_elastic_on_ranks;
/// Likewise: see implicit_on_ranks.cpp.
[[nodiscard]] std::unique_ptr<MotionOnRanks> make_implicit_dynamics_on_ranks(
    const Ranks& ranks, const std::vector<MeshLevel>& levels, const Loading& loading, const DynamicSettings& settings,
    std::optional<index_t> replicated, const DistributedOptions& options);

}  // namespace physgen::fem
