// The solvers that a build has beside those of newton_solvers.h and scene_solvers.h.
#pragma once

#include <fem/solver/dynamic_solver.h>
#include <fem/solver/quasistatic.h>

namespace physgen::fem {

[[nodiscard]] std::unique_ptr<EquilibriumSolver> make_host_linear_solver(const std::vector<MeshLevel>& levels,
                                                                         const Loading& loading,
                                                                         const SolverSettings& settings);
/// In a build with CUDA.
[[nodiscard]] std::unique_ptr<EquilibriumSolver> make_cuda_linear_solver(const std::vector<MeshLevel>& levels,
                                                                         const Loading& loading,
                                                                         const SolverSettings& settings);

/// In a build with CUDA.
[[nodiscard]] std::string cuda_device_name();

}  // namespace physgen::fem
