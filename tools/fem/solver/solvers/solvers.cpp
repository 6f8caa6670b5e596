#include <fem/solver/arrays/run_time_choices.h>
#include <fem/solver/material_names.h>
#include <fem/solver/solvers/in_precision.h>
#include <fem/solver/solvers/newton_solvers.h>
#include <fem/solver/solvers/require.h>
#include <fem/solver/solvers/scene_solvers.h>
#include <fem/solver/solvers/solvers.h>
#include <fem/solver/solvers/turned.h>
#include <physgen/error.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <type_traits>

namespace physgen::fem {

namespace {

/// @throw Error naming what is wrong with what a solver by Newton's method is given
void require_nonlinear(const std::vector<MeshLevel>& levels, const Loading& loading, const SolverSettings& settings) {
  require_meshes(levels);
  require_settings(settings);
  require_materials(levels, settings);
  require_loading(levels.front(), loading);
  if (!loading.pressures.empty() && settings.newton.product == Product::matrix_free) {
    throw Error(
        "pressures that follow the surface require the assembled product: the matrix-free one has only the stiffness "
        "of tets");
  }
  if (!loading.planes.empty() && settings.newton.product == Product::matrix_free) {
    throw Error("rigid planes require the assembled product: the matrix-free one has only the stiffness of tets");
  }
  const bool patches = !levels.front().patches.nodes.empty(), nodes_average = levels.front().averages_at_nodes;
  for (std::size_t l = 0; nodes_average && l < levels.size() && !levels[l].is_grid(); ++l) {
    const auto& first = levels[l].mesh.node_tets.first;
    const auto stray = std::ranges::adjacent_find(first);
    if (stray == first.end()) continue;
    throw Error("level " + std::to_string(l) + ": node " + std::to_string(stray - first.begin()) +
                " is in no tet, and has no volume to average; remove it");
  }
  if (nodes_average && settings.newton.product == Product::matrix_free) {
    throw Error(
        "volumes averaged at nodes require the assembled product: the matrix-free one has only the tangents of tets "
        "and patches");
  }
  for (const MeshLevel& level : levels) {
    if (level.is_grid()) continue;
    if (level.patches.nodes.empty() == patches) throw Error("either all levels have patches, or none");
    if (level.averages_at_nodes != nodes_average)
      throw Error("volumes are averaged at nodes on all levels, or on none");
    if (patches && nodes_average) throw Error("volumes are averaged over patches or at nodes, and not both");
  }
  for (std::size_t l = 0; patches && l + 1 < levels.size(); ++l) {
    const auto& parents = levels[l].patch_parents;
    const auto coarse = static_cast<Index>(levels[l + 1].patches.nodes.size());
    const auto outside = [=](Index p) { return p < 0 || p >= coarse; };
    if (parents.empty()) continue;  // pressures are not injected then
    if (parents.size() != levels[l].patches.nodes.size() || std::ranges::any_of(parents, outside)) {
      throw Error("level " + std::to_string(l) + ": each patch needs a parent among the " + std::to_string(coarse) +
                  " patches of the next coarser level, or none has one");
    }
  }
  if (!can_average_volume(settings.material) && (patches || nodes_average)) refuse_averages(settings.material);
}

}  // namespace

std::string device_name(Device device) {
  if (device == Device::cpu) return "cpu";
#ifdef PHYSGEN_SOLVER_HAS_CUDA
  return cuda_device_name();
#else
  refuse_cuda();
#endif
}

std::unique_ptr<QuasistaticSolver> make_solver(const std::vector<MeshLevel>& levels, const Loading& loading,
                                               const SolverSettings& given) {
  if (!levels.empty() && levels.front().axes) {
    const Turn turn(*levels.front().axes);
    return turn.back(make_solver(turn.along(levels), turn.along(loading), given));
  }
  const SolverSettings settings = with_largest(given);
  require_nonlinear(levels, loading, settings);
  return in_precision(settings.precision, [&]<class Real, class Stored>() {
    if (settings.device == Device::cpu)
      return NewtonSolvers<HostExecutor, Real, Stored>::make(levels, loading, settings);
#ifdef PHYSGEN_SOLVER_HAS_CUDA
    return NewtonSolvers<CudaExecutor, Real, Stored>::make(levels, loading, settings);
#else
    refuse_cuda();
#endif
  });
}

namespace {

/// The name by which users choose a material.
template <class Material>
const char* name_of_material() {
  const char* found = "";
  for_each_material([&]<class Other>(const char* name) {
    if (std::is_same_v<Other, Material>) found = name;
  });
  return found;
}

enum class Volumes { by_patches, by_tets, by_either };
#define PHYSGEN_SCENE_ROW(scene, word, Material, Choices, volumes, ...) \
  SceneRow{#scene,                                                      \
           word,                                                        \
           name_of_material<Material<double>>(),                        \
           Material<double>::name,                                      \
           Choices::assembled,                                          \
           Volumes::volumes != Volumes::by_tets,                        \
           Volumes::volumes != Volumes::by_patches},
const SceneRow implicit_scene[] = {PHYSGEN_IMPLICIT_SCENES(PHYSGEN_SCENE_ROW)};

/// The solvers of a scene in the order of the rows.
struct SceneSolver {
  MakeSceneSolver *on_cpu, *on_cuda;
};
#ifdef PHYSGEN_SOLVER_HAS_CUDA
#define PHYSGEN_SCENE_SOLVER(scene, ...) {&make_host_##scene##_solver, &make_cuda_##scene##_solver},
#else
#define PHYSGEN_SCENE_SOLVER(scene, ...) {&make_host_##scene##_solver, nullptr},
#endif
constexpr SceneSolver scene_solvers[] = {PHYSGEN_EQUILIBRIUM_SCENES(PHYSGEN_SCENE_SOLVER)};

/// @throw Error naming what was requested that the scene does not have
void require_declared(const SceneRow& scene, const std::vector<MeshLevel>& levels, const Loading& loading,
                      const SolverSettings& settings) {
  const auto require = [&](bool holds, const std::string& what) {
    if (!holds) throw Error("the scene " + std::string(scene.name) + " " + what);
  };
  const NewtonSettings& newton = settings.newton;
  require(settings.precision == TangentPrecision::float32, "is in float, but another precision was requested");
  require(settings.material == scene.material,
          "is of the material '" + std::string(scene.material) + "', but '" + settings.material + "' was requested");
  require((newton.product == Product::assembled) == scene.assembled,
          scene.assembled ? "assembles its stiffness, but the matrix-free product was requested"
                          : "assembles no stiffness, but the assembled product was requested");
  const PreconditionerRow& preconditioner = row_of(newton.preconditioner.kind);
  require((preconditioner.asked & asks::arrays) == 0,
          "has no " + std::string(preconditioner.title) + " preconditioner");
  require(loading.planes.empty(), "has no rigid planes");
  require(loading.pressures.empty(), "has no pressures that follow the surface");
  require(settings.materials.empty(), "has one material");
  for (const MeshLevel& level : levels) {
    require(!level.is_grid(), "has no levels of a background grid; give meshes whose coarsest is small");
    require(!level.averages_at_nodes, "averages no volumes at nodes");
    const bool has_patches = !level.patches.nodes.empty();
    require(has_patches || scene.tets, "averages volumes over patches, but a level has none");
    require(!has_patches || scene.patches, "takes the volumes of single tets, but a level has patches");
  }
}

/// @throw Error naming what is wrong with what a solver of motion by Newton's method is given
void require_implicit(const std::vector<MeshLevel>& levels, const Loading& loading, const DynamicSettings& settings) {
  require_nonlinear(levels, loading, settings.solver);
  require_motion(settings);
  if (settings.solver.newton.product == Product::matrix_free) {
    throw Error("inertia requires the assembled product: the matrix-free one has only the stiffness of tets");
  }
}

}  // namespace

std::span<const SceneRow> equilibrium_scenes() {
  static const SceneRow rows[] = {PHYSGEN_EQUILIBRIUM_SCENES(PHYSGEN_SCENE_ROW)};
  return rows;
}

namespace {

/// @throw Error when there is no such scene, which names all
const SceneRow& row_of_scene(const std::string& scene) {
  const auto rows = equilibrium_scenes();
  const auto row = std::ranges::find_if(rows, [&](const SceneRow& known) { return scene == known.name; });
  if (row != rows.end()) return *row;
  std::string names;
  for (const SceneRow& known : rows) names += (names.empty() ? "" : ", ") + std::string(known.name);
  throw Error("no solver is built for a scene '" + scene + "'; there are " + names);
}

}  // namespace

void require_scene_solver(const std::string& scene, const std::vector<MeshLevel>& levels, const Loading& loading,
                          const SolverSettings& settings) {
  require_declared(row_of_scene(scene), levels, loading, settings);
  require_nonlinear(levels, loading, settings);
}

void require_solver(const std::vector<MeshLevel>& levels, const Loading& loading, const SolverSettings& settings) {
  require_nonlinear(levels, loading, with_largest(settings));
}

std::unique_ptr<EquilibriumSolver> make_scene_solver(const std::string& scene, const std::vector<MeshLevel>& levels,
                                                     const Loading& loading, const SolverSettings& settings) {
  if (!levels.empty() && levels.front().axes) {
    const Turn turn(*levels.front().axes);
    return turn.back(make_scene_solver(scene, turn.along(levels), turn.along(loading), settings));
  }
  require_scene_solver(scene, levels, loading, settings);
  const SceneSolver& solver = scene_solvers[&row_of_scene(scene) - equilibrium_scenes().data()];
  if (settings.device == Device::cpu) return solver.on_cpu(levels, loading, settings);
  if (solver.on_cuda == nullptr) refuse_cuda();
  return solver.on_cuda(levels, loading, settings);
}

void require_scene_implicit_solver(const std::vector<MeshLevel>& levels, const Loading& loading,
                                   const DynamicSettings& settings) {
  require_declared(implicit_scene[0], levels, loading, settings.solver);
  require_implicit(levels, loading, settings);
}

std::unique_ptr<DynamicSolver> make_scene_implicit_solver(const std::vector<MeshLevel>& levels, const Loading& loading,
                                                          const DynamicSettings& settings) {
  require_scene_implicit_solver(levels, loading, settings);
  if (settings.solver.device == Device::cpu) return make_host_implicit_dynamics_solver(levels, loading, settings);
#ifdef PHYSGEN_SOLVER_HAS_CUDA
  return make_cuda_implicit_dynamics_solver(levels, loading, settings);
#else
  refuse_cuda();
#endif
}

std::unique_ptr<EquilibriumSolver> make_linear_solver(const std::vector<MeshLevel>& levels, const Loading& loading,
                                                      const SolverSettings& settings) {
  if (!levels.empty() && levels.front().axes) {
    const Turn turn(*levels.front().axes);
    return turn.back(make_linear_solver(turn.along(levels), turn.along(loading), settings));
  }
  require_linear_solver(levels, loading, settings);
  if (settings.device == Device::cpu) return make_host_linear_solver(levels, loading, settings);
#ifdef PHYSGEN_SOLVER_HAS_CUDA
  return make_cuda_linear_solver(levels, loading, settings);
#else
  refuse_cuda();
#endif
}

std::unique_ptr<DynamicSolver> make_implicit_solver(const std::vector<MeshLevel>& levels, const Loading& loading,
                                                    const DynamicSettings& given) {
  DynamicSettings settings = given;
  settings.solver = with_largest(settings.solver);
  require_implicit(levels, loading, settings);
  return in_precision(settings.solver.precision, [&]<class Real, class Stored>() {
    if (settings.solver.device == Device::cpu) {
      return NewtonSolvers<HostExecutor, Real, Stored>::make_implicit(levels, loading, settings);
    }
#ifdef PHYSGEN_SOLVER_HAS_CUDA
    return NewtonSolvers<CudaExecutor, Real, Stored>::make_implicit(levels, loading, settings);
#else
    refuse_cuda();
#endif
  });
}

}  // namespace physgen::fem
