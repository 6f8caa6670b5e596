// The solver on the CPU, in each precision.
#include <fem/solver/make_evaluator.h>
#include <fem/solver/product_host.h>
#include <fem/solver/schwarz_host.h>
#include <fem/solver/solver_of.h>
#include <fem/solver/solvers.h>

namespace physgen::fem {

PHYSGEN_EVALUATORS_ARE_COMPILED_ELSEWHERE(HostExecutor, float, Host)
PHYSGEN_EVALUATORS_ARE_COMPILED_ELSEWHERE(HostExecutor, double, Host)

std::unique_ptr<QuasistaticSolver> make_host_solver(const std::vector<MeshLevel>& levels, const Loading& loading,
                                                    const SolverSettings& settings) {
  switch (settings.precision) {
    case TangentPrecision::half:
      return std::make_unique<SolverOf<HostExecutor, float, StoredInHalf>>(levels, loading, settings);
    case TangentPrecision::float32:
      return std::make_unique<SolverOf<HostExecutor, float, StoredAsComputed>>(levels, loading, settings);
    case TangentPrecision::float64:
      break;
  }
  return std::make_unique<SolverOf<HostExecutor, double, StoredAsComputed>>(levels, loading, settings);
}

}  // namespace physgen::fem
