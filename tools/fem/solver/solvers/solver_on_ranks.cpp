#include <fem/solver/linear/performed_steps.h>
#include <fem/solver/solvers/quasistatic_on_ranks.h>
#include <fem/solver/solvers/require.h>
#include <fem/solver/solvers/scene_solvers.h>
#include <fem/solver/solvers/solver_on_ranks.h>

namespace physgen::fem {

std::unique_ptr<SolverOnRanks> make_solver_on_ranks(const Ranks& ranks, const std::vector<MeshLevel>& levels,
                                                    const Loading& loading, const SolverSettings& settings,
                                                    std::optional<index_t> replicated,
                                                    const DistributedOptions& options) {
  require_scene_solver("quasistatic", levels, loading, settings);
  const auto refuse = [](const std::string& what) {
    throw Error("several ranks do not have " + what + ", or solve in one process");
  };
  if (levels.front().axes) refuse("supports along axes of their own; turn the body");
#ifndef PHYSGEN_SOLVER_HAS_CUDA
  if (settings.device != Device::cpu) refuse_cuda();
#endif
  const bool inverts = settings.newton.preconditioner.kind == Preconditioner::multigrid && levels.size() == 1;
  if (inverts && levels.front().mesh.nodes <= most_coarse_nodes) {
    refuse("multigrid over one level of at most " + std::to_string(most_coarse_nodes) +
           " nodes, which is inverted as a whole; take more cells or another preconditioner");
  }
  WholeBody whole(ranks, levels, loading, settings, replicated);
#ifdef PHYSGEN_SOLVER_HAS_CUDA
  if (settings.device == Device::cuda) {
    if (settings.before_device) settings.before_device();
    return make_cuda_solver_on_ranks(ranks, std::move(whole), settings, options);
  }
#endif
  return std::make_unique<QuasistaticOnRanks<DistributedExecutor<HostExecutor>>>(ranks, std::move(whole), settings,
                                                                                 options);
}

}  // namespace physgen::fem
