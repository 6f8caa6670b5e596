#include <fem/solver/hierarchy/hierarchy.h>
#include <fem/solver/solvers/require.h>
#include <fem/solver/solvers/scene_solvers.h>
#include <fem/solver/solvers/solvers_on_ranks.h>
#include <physgen/error.h>

#include <algorithm>
#include <string>
#ifdef PHYSGEN_SOLVER_HAS_CUDA
#include <fem/solver/linear/performed_steps.h>
#include <fem/solver/solvers/quasistatic_on_ranks_cuda.h>
#endif

namespace physgen::fem {

namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw Error("several ranks do not have " + what + ", or solve in one process");
}

/// @throw Error naming what the scene everything has in one process alone
void require_everything_on_ranks(const std::vector<MeshLevel>& levels, const Loading& loading,
                                 const SolverSettings& settings) {
  if (settings.device != Device::cpu) refuse("the scene everything on CUDA; choose the scene quasistatic");
  if (settings.precision == TangentPrecision::float64) refuse("tangents in double; take them in float or half");
  if (settings.newton.product != Product::assembled) {
    refuse("the matrix-free product of the scene everything; choose the assembled one");
  }
  const PreconditionerRow& preconditioner = row_of(settings.newton.preconditioner.kind);
  if ((preconditioner.asked & asks::arrays) != 0) {
    refuse("the " + std::string(preconditioner.title) + " preconditioner; take another");
  }
  if (levels.front().averages_at_nodes) refuse("volumes averaged at nodes; average them over patches");
  if (!loading.pressures.empty()) refuse("pressures that follow the surface; give them as forces at rest");
}

}  // namespace

std::unique_ptr<SolverOnRanks> make_solver_on_ranks(const Ranks& ranks, const std::string& scene,
                                                    const std::vector<MeshLevel>& levels, const Loading& loading,
                                                    const SolverSettings& settings, std::optional<index_t> replicated,
                                                    const DistributedOptions& options) {
  const bool is_everything = scene == "everything";
  if (is_everything) {
    require_solver(levels, loading, settings);
    require_everything_on_ranks(levels, loading, settings);
  } else {
    require_scene_solver(scene, levels, loading, settings);
  }
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
  if (is_everything) {
    return make_everything_on_ranks(ranks, levels, loading, with_largest(settings), replicated, options);
  }
#define PHYSGEN_ON_RANKS(scene, ...) &make_##scene##_on_ranks,
  constexpr MakeSolverOnRanks* make[] = {PHYSGEN_EQUILIBRIUM_SCENES(PHYSGEN_ON_RANKS)};
#undef PHYSGEN_ON_RANKS
  const auto rows = equilibrium_scenes();
  const auto row = std::ranges::find_if(rows, [&](const SceneRow& known) { return scene == known.name; });
  return make[row - rows.begin()](ranks, levels, loading, settings, replicated, options);
}

}  // namespace physgen::fem
