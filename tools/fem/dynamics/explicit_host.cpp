// The explicit solver on the CPU, in each precision.
#include <fem/dynamics/explicit_solver_of.h>
#include <fem/dynamics/explicit_solvers.h>
#include <physgen/executor.h>

namespace physgen::fem {

std::unique_ptr<DynamicSolver> make_host_explicit_solver(const MeshLevel& level, const Loading& loading,
                                                         const DynamicSettings& settings) {
  if (settings.solver.precision == TangentPrecision::float64) {
    return std::make_unique<ExplicitSolverOf<HostExecutor, double>>(level, loading, settings);
  }
  return std::make_unique<ExplicitSolverOf<HostExecutor, float>>(level, loading, settings);
}

}  // namespace physgen::fem
