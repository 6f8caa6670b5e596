// The solvers by Newton's method over one executor in one precision, each compiled by itself (newton_solvers.in).
#pragma once

#include <fem/solver/dynamic_solver.h>
#include <fem/solver/quasistatic.h>

#include <memory>
#include <vector>

namespace physgen {
class HostExecutor;
class CudaExecutor;
}  // namespace physgen

namespace physgen::fem {

/// @tparam On HostExecutor or CudaExecutor
/// @tparam Real of the tangent
/// @tparam Stored how preconditioners store their matrices, of stored.h
template <class On, class Real, class Stored>
struct NewtonSolvers {
  [[nodiscard]] static std::unique_ptr<QuasistaticSolver> make(const std::vector<MeshLevel>& levels,
                                                               const Loading& loading, const SolverSettings& settings);
  [[nodiscard]] static std::unique_ptr<DynamicSolver> make_implicit(const std::vector<MeshLevel>& levels,
                                                                    const Loading& loading,
                                                                    const DynamicSettings& settings);
};

}  // namespace physgen::fem
