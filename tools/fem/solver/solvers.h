// The solvers that a build has.
#pragma once

#include <fem/solver/quasistatic.h>

namespace physgen::fem {

[[nodiscard]] std::unique_ptr<QuasistaticSolver> make_host_solver(const std::vector<MeshLevel>& levels,
                                                                  const Loading& loading,
                                                                  const SolverSettings& settings);
/// In a build with CUDA.
[[nodiscard]] std::unique_ptr<QuasistaticSolver> make_cuda_solver(const std::vector<MeshLevel>& levels,
                                                                  const Loading& loading,
                                                                  const SolverSettings& settings);

[[nodiscard]] std::string cuda_device_name();

}  // namespace physgen::fem
