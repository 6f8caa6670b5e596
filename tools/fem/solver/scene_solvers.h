// The solvers that run one scene each, over arrays with the fields alone that it needs.
#pragma once

#include <fem/solver/quasistatic.h>

#include <memory>
#include <string>
#include <vector>

namespace physgen::fem {

/// Equilibria of a scene by name: quasistatic, quasistatic_matrix_free, quasistatic_fixed_corotated, linear_elastic.
/// @throw Error when there is no such scene; naming what settings, levels or loading ask for that it has not; and as
/// make_solver() and make_linear_solver() do
[[nodiscard]] std::unique_ptr<EquilibriumSolver> make_scene_solver(const std::string& scene,
                                                                   const std::vector<MeshLevel>& levels,
                                                                   const Loading& loading,
                                                                   const SolverSettings& settings);

/// Each is compiled by itself: see scene_solver.in. @pre nothing is asked for that the scene has not
using MakeSceneSolver = std::unique_ptr<EquilibriumSolver>(const std::vector<MeshLevel>& levels, const Loading& loading,
                                                           const SolverSettings& settings);
MakeSceneSolver make_host_quasistatic_solver, make_host_quasistatic_matrix_free_solver,
    make_host_quasistatic_fixed_corotated_solver, make_host_linear_elastic_solver;
/// In a build with CUDA.
MakeSceneSolver make_cuda_quasistatic_solver, make_cuda_quasistatic_matrix_free_solver,
    make_cuda_quasistatic_fixed_corotated_solver, make_cuda_linear_elastic_solver;

}  // namespace physgen::fem
