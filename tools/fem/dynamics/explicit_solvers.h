// The explicit solvers that a build has.
#pragma once

#include <fem/solver/dynamic_solver.h>

namespace physgen::fem {

[[nodiscard]] std::unique_ptr<DynamicSolver> make_host_explicit_solver(const MeshLevel& level, const Loading& loading,
                                                                       const DynamicSettings& settings);
/// In a build with CUDA.
[[nodiscard]] std::unique_ptr<DynamicSolver> make_cuda_explicit_solver(const MeshLevel& level, const Loading& loading,
                                                                       const DynamicSettings& settings);

}  // namespace physgen::fem
