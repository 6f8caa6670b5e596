#include <fem/solver/hierarchy/hierarchy.h>
#include <fem/solver/solvers/require.h>
#include <fem/solver/solvers/scene_solvers.h>
#include <fem/solver/solvers/solvers_on_ranks.h>
#include <physgen/error.h>

#include <algorithm>
#ifdef PHYSGEN_SOLVER_HAS_CUDA
#include <fem/solver/linear/performed_steps.h>
#include <fem/solver/solvers/quasistatic_on_ranks_cuda.h>
#endif

namespace physgen::fem {

std::unique_ptr<SolverOnRanks> make_solver_on_ranks(const Ranks& ranks, const std::string& scene,
                                                    const std::vector<MeshLevel>& levels, const Loading& loading,
                                                    const SolverSettings& settings, std::optional<index_t> replicated,
                                                    const DistributedOptions& options) {
  require_scene_solver(scene, levels, loading, settings);
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
#ifdef PHYSGEN_SOLVER_HAS_CUDA
  if (settings.device == Device::cuda) {
    if (scene != "quasistatic")
      refuse("the scene " + scene + " on CUDA; choose the scene quasistatic, or the device cpu");
    if (settings.before_device) settings.before_device();
    return make_cuda_quasistatic_on_ranks(
        ranks, WholeBody<scenes::quasistatic>(ranks, levels, loading, settings, replicated), settings, options);
  }
#endif
#define PHYSGEN_ON_RANKS(scene, ...) &make_##scene##_on_ranks,
  constexpr MakeSolverOnRanks* make[] = {PHYSGEN_EQUILIBRIUM_SCENES(PHYSGEN_ON_RANKS)};
#undef PHYSGEN_ON_RANKS
  const auto rows = equilibrium_scenes();
  const auto row = std::ranges::find_if(rows, [&](const SceneRow& known) { return scene == known.name; });
  return make[row - rows.begin()](ranks, levels, loading, settings, replicated, options);
}

}  // namespace physgen::fem
