// The solvers that run one scene each, over arrays with the fields alone that it needs.
#pragma once

#include <fem/solver/dynamic_solver.h>
#include <fem/solver/quasistatic.h>
#include <fem/solver/scene_rows.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace physgen::fem {

/// The rows of PHYSGEN_EQUILIBRIUM_SCENES.
[[nodiscard]] std::span<const SceneRow> equilibrium_scenes();

/// Equilibria of one of these scenes by name.
/// @throw Error when there is no such scene; naming what settings, levels or loading ask for that it has not; and as
/// make_solver() does
[[nodiscard]] std::unique_ptr<EquilibriumSolver> make_scene_solver(const std::string& scene,
                                                                   const std::vector<MeshLevel>& levels,
                                                                   const Loading& loading,
                                                                   const SolverSettings& settings);

/// @throw Error as make_scene_solver() does, but for a device or memory that is not there
void require_scene_solver(const std::string& scene, const std::vector<MeshLevel>& levels, const Loading& loading,
                          const SolverSettings& settings);

/// @throw Error as make_solver() does, but for a device or memory that is not there
void require_solver(const std::vector<MeshLevel>& levels, const Loading& loading, const SolverSettings& settings);

/// Motion of the scene implicit_dynamics: of stable Neo-Hookean bodies, in float, whose volumes are those of tets or
/// patches, by every preconditioner of assembled products on meshes without extra arrays.
/// @throw Error naming what settings, levels or loading ask for that it has not; and as make_implicit_solver() does
[[nodiscard]] std::unique_ptr<DynamicSolver> make_scene_implicit_solver(const std::vector<MeshLevel>& levels,
                                                                        const Loading& loading,
                                                                        const DynamicSettings& settings);

/// @throw Error as make_scene_implicit_solver() does, but for a device or memory that is not there
void require_scene_implicit_solver(const std::vector<MeshLevel>& levels, const Loading& loading,
                                   const DynamicSettings& settings);

/// Those of an executor are compiled as one file: see scene_solver.in. @pre nothing is asked for that the scene has not
using MakeSceneSolver = std::unique_ptr<EquilibriumSolver>(const std::vector<MeshLevel>& levels, const Loading& loading,
                                                           const SolverSettings& settings);
using MakeSceneImplicitSolver = std::unique_ptr<DynamicSolver>(const std::vector<MeshLevel>& levels,
                                                               const Loading& loading, const DynamicSettings& settings);
/// Those on CUDA are in a build with CUDA.
#define PHYSGEN_DECLARE_SOLVERS(scene, word, Material, Choices, volumes, Make, ...) \
  Make make_host_##scene##_solver, make_cuda_##scene##_solver;
PHYSGEN_EQUILIBRIUM_SCENES(PHYSGEN_DECLARE_SOLVERS, MakeSceneSolver)
PHYSGEN_IMPLICIT_SCENES(PHYSGEN_DECLARE_SOLVERS, MakeSceneImplicitSolver)
#undef PHYSGEN_DECLARE_SOLVERS

}  // namespace physgen::fem
