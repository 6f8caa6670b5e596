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

/// @throw Error for a preconditioner that has arrays of its own beside those of levels
void refuse_more_arrays(const SolverSettings& settings) {
  const PreconditionerRow& preconditioner = row_of(settings.newton.preconditioner.kind);
  if ((preconditioner.asked & asks::arrays) != 0) {
    refuse("the " + std::string(preconditioner.title) + " preconditioner; take another");
  }
}

/// @throw Error naming what the scene everything has in one process alone
void require_everything_on_ranks(const std::vector<MeshLevel>& levels, const Loading& loading,
                                 const SolverSettings& settings) {
  if (settings.device != Device::cpu) refuse("the scene everything on CUDA; choose the scene quasistatic");
  if (settings.precision == TangentPrecision::float64) refuse("tangents in double; take them in float or half");
  if (settings.newton.product != Product::assembled) {
    refuse("the matrix-free product of the scene everything; choose the assembled one");
  }
  refuse_more_arrays(settings);
  if (levels.front().averages_at_nodes) refuse("volumes averaged at nodes; average them over patches");
  if (!loading.pressures.empty()) refuse("pressures that follow the surface; give them as forces at rest");
}

/// In one process make_solver() turns the body for them. To be called before checks that one process makes of what is
/// turned. @throw Error where supports have axes of their own
void refuse_axes(const std::vector<MeshLevel>& levels) {
  if (!levels.empty() && levels.front().axes) {
    refuse("supports along other axes than x, y and z; turn the body so that they lie along these");
  }
}

/// @throw Error naming what one process has, and several ranks have not
void require_parts(const std::vector<MeshLevel>& levels, const SolverSettings& settings) {
#ifndef PHYSGEN_SOLVER_HAS_CUDA
  if (settings.device != Device::cpu) refuse_cuda();
#endif
  const bool inverts = settings.newton.preconditioner.kind == Preconditioner::multigrid && levels.size() == 1;
  if (inverts && levels.front().mesh.nodes <= most_coarse_nodes) {
    refuse("multigrid over one level of at most " + std::to_string(most_coarse_nodes) +
           " nodes, which is inverted as a whole; take more cells or another preconditioner");
  }
}

/// For a scene that several ranks have on CPUs alone. @throw Error for another device
void require_on_cpu(const std::string& scene, const SolverSettings& settings) {
  if (settings.device != Device::cpu) {
    refuse("the scene " + scene + " on CUDA; choose the scene quasistatic, or the device cpu");
  }
}

}  // namespace

std::unique_ptr<SolverOnRanks> make_solver_on_ranks(const Ranks& ranks, const std::string& scene,
                                                    const std::vector<MeshLevel>& levels, const Loading& loading,
                                                    const SolverSettings& settings, std::optional<index_t> replicated,
                                                    const DistributedOptions& options) {
  refuse_axes(levels);
  const bool is_everything = scene == "everything";
  if (is_everything) {
    require_solver(levels, loading, settings);
    require_everything_on_ranks(levels, loading, settings);
  } else {
    require_scene_solver(scene, levels, loading, settings);
  }
  require_parts(levels, settings);
#ifdef PHYSGEN_SOLVER_HAS_CUDA
  if (settings.device == Device::cuda) {
    if (scene != "quasistatic") require_on_cpu(scene, settings);
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

std::unique_ptr<MotionOnRanks> make_implicit_solver_on_ranks(const Ranks& ranks, const std::vector<MeshLevel>& levels,
                                                             const Loading& loading, const DynamicSettings& settings,
                                                             std::optional<index_t> replicated,
                                                             const DistributedOptions& options) {
  require_scene_implicit_solver(levels, loading, settings);
  require_parts(levels, settings.solver);
  require_on_cpu("implicit_dynamics", settings.solver);
  return make_implicit_dynamics_on_ranks(ranks, levels, loading, settings, replicated, options);
}

std::unique_ptr<SolverOnRanks> make_linear_solver_on_ranks(const Ranks& ranks, const std::vector<MeshLevel>& levels,
                                                           const Loading& loading, const SolverSettings& settings,
                                                           std::optional<index_t> replicated,
                                                           const DistributedOptions& options) {
  refuse_axes(levels);
  require_linear_solver(levels, loading, settings);
  require_parts(levels, settings);
  require_on_cpu("linear_elastic", settings);
  refuse_more_arrays(settings);
  if (std::ranges::any_of(levels, &MeshLevel::is_grid)) {
    refuse(
        "linear elastic bodies with levels of a background grid; give meshes whose coarsest is small, or another "
        "preconditioner");
  }
  return make_linear_elastic_on_ranks(ranks, levels, loading, settings, replicated, options);
}

}  // namespace physgen::fem
