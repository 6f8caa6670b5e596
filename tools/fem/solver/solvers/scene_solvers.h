// The solvers that run one scene each, over arrays with the fields alone that it needs.
#pragma once

#include <fem/solver/dynamic_solver.h>
#include <fem/solver/quasistatic.h>

#include <memory>
#include <string>
#include <vector>

namespace physgen::fem {

/// Equilibria of a scene by name: quasistatic, quasistatic_matrix_free, quasistatic_fixed_corotated.
/// @throw Error when there is no such scene; naming what settings, levels or loading ask for that it has not; and as
/// make_solver() does
[[nodiscard]] std::unique_ptr<EquilibriumSolver> make_scene_solver(const std::string& scene,
                                                                   const std::vector<MeshLevel>& levels,
                                                                   const Loading& loading,
                                                                   const SolverSettings& settings);

/// Motion of the scene implicit_dynamics: of stable Neo-Hookean bodies, in float, whose volumes are those of tets or
/// patches, by every preconditioner of assembled products on meshes without extra arrays.
/// @throw Error naming what settings, levels or loading ask for that it has not; and as make_implicit_solver() does
[[nodiscard]] std::unique_ptr<DynamicSolver> make_scene_implicit_solver(const std::vector<MeshLevel>& levels,
                                                                        const Loading& loading,
                                                                        const DynamicSettings& settings);

/// Each is compiled by itself: see scene_solver.in. @pre nothing is asked for that the scene has not
using MakeSceneSolver = std::unique_ptr<EquilibriumSolver>(const std::vector<MeshLevel>& levels, const Loading& loading,
                                                           const SolverSettings& settings);
MakeSceneSolver make_host_quasistatic_solver, make_host_quasistatic_matrix_free_solver,
    make_host_quasistatic_fixed_corotated_solver;
/// In a build with CUDA.
MakeSceneSolver make_cuda_quasistatic_solver, make_cuda_quasistatic_matrix_free_solver,
    make_cuda_quasistatic_fixed_corotated_solver;

using MakeSceneImplicitSolver = std::unique_ptr<DynamicSolver>(const std::vector<MeshLevel>& levels,
                                                               const Loading& loading, const DynamicSettings& settings);
MakeSceneImplicitSolver make_host_implicit_dynamics_solver;
/// In a build with CUDA.
MakeSceneImplicitSolver make_cuda_implicit_dynamics_solver;

}  // namespace physgen::fem
