// The solver on several ranks (runtime/distributed.md): each has a part of the finest mesh and of large coarser ones,
// and all have the others. Equilibria on the CPU have the bits of one process.
#pragma once

#include <fem/solver/quasistatic.h>
#include <physgen/distributed/options.h>
#include <physgen/distributed/ranks.h>
#include <physgen/distributed/transport.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace physgen::fem {

/// What a rank has of the finest mesh.
struct PartOfMesh {
  index_t owned_nodes = 0, ghost_nodes = 0, owned_tets = 0, ghost_tets = 0;
};

/// All ranks call each function, with the same arguments, and get the same values: those of the whole mesh.
/// set_loading() is refused.
class SolverOnRanks : public EquilibriumSolver {
 public:
  [[nodiscard]] virtual PartOfMesh part() const = 0;
  /// What has crossed so far, seen from this rank.
  [[nodiscard]] virtual Traffic traffic() const = 0;
  /// By what it crosses: "MPI", or on CUDA as DistributedExecutor's transport_name() says.
  [[nodiscard]] virtual std::string transport() const = 0;
};

/// Equilibria of the scene quasistatic, by tets or patches. bytes() are those of this rank. On CUDA each rank takes a
/// device, sums are formed in a fixed order, and equilibria have the bits of one rank.
/// @param levels the same on all ranks, as loading and settings. Of a box a rank makes the lists of its part alone, and
/// those of levels that are cut may be missing (cube_levels.h); of other meshes it has those of the whole for a while
/// @param replicated coarser meshes of more nodes are cut, too, but for the coarsest; without it those of
/// levels_that_are_cut()
/// @throw Error as make_scene_solver(); and for supports along axes of their own, for multigrid over one level that is
/// inverted as a whole, which one process has, for CUDA in a build without it, and where ranks would share a GPU
[[nodiscard]] std::unique_ptr<SolverOnRanks> make_solver_on_ranks(
    const Ranks& ranks, const std::vector<MeshLevel>& levels, const Loading& loading, const SolverSettings& settings,
    std::optional<index_t> replicated = {}, const DistributedOptions& options = {});

}  // namespace physgen::fem
