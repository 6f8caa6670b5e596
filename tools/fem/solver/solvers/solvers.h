// The solvers that a build has.
#pragma once

#include <fem/solver/dynamic_solver.h>
#include <fem/solver/quasistatic.h>

namespace physgen::fem {

[[nodiscard]] std::unique_ptr<QuasistaticSolver> make_host_solver(const std::vector<MeshLevel>& levels,
                                                                  const Loading& loading,
                                                                  const SolverSettings& settings);
/// In a build with CUDA.
[[nodiscard]] std::unique_ptr<QuasistaticSolver> make_cuda_solver(const std::vector<MeshLevel>& levels,
                                                                  const Loading& loading,
                                                                  const SolverSettings& settings);

[[nodiscard]] std::unique_ptr<EquilibriumSolver> make_host_linear_solver(const std::vector<MeshLevel>& levels,
                                                                         const Loading& loading,
                                                                         const SolverSettings& settings);
[[nodiscard]] std::unique_ptr<EquilibriumSolver> make_cuda_linear_solver(const std::vector<MeshLevel>& levels,
                                                                         const Loading& loading,
                                                                         const SolverSettings& settings);

[[nodiscard]] std::unique_ptr<DynamicSolver> make_host_implicit_solver(const std::vector<MeshLevel>& levels,
                                                                       const Loading& loading,
                                                                       const DynamicSettings& settings);
[[nodiscard]] std::unique_ptr<DynamicSolver> make_cuda_implicit_solver(const std::vector<MeshLevel>& levels,
                                                                       const Loading& loading,
                                                                       const DynamicSettings& settings);

[[nodiscard]] std::string cuda_device_name();

}  // namespace physgen::fem
