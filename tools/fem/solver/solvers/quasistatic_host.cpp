// The solvers by Newton's method on the CPU, in each precision.
#include <fem/solver/linear/performed_steps.h>
#include <fem/solver/solvers/implicit_solver_of.h>
#include <fem/solver/solvers/in_precision.h>
#include <fem/solver/solvers/make_evaluator.h>
#include <fem/solver/solvers/solver_of.h>
#include <fem/solver/solvers/solver_types.h>
#include <fem/solver/solvers/solvers.h>

namespace physgen::fem {

PHYSGEN_EVALUATORS_ARE_COMPILED_ELSEWHERE(HostExecutor, float, Host)
PHYSGEN_EVALUATORS_ARE_COMPILED_ELSEWHERE(HostExecutor, double, Host)

std::unique_ptr<QuasistaticSolver> make_host_solver(const std::vector<MeshLevel>& levels, const Loading& loading,
                                                    const SolverSettings& settings) {
  using Made = std::unique_ptr<QuasistaticSolver>;
  return in_precision(settings.precision, [&]<class Real, class Stored>() -> Made {
    return std::make_unique<SolverOf<HostExecutor, SolverTypes<HostExecutor, Real, Stored>>>(levels, loading, settings);
  });
}

std::unique_ptr<DynamicSolver> make_host_implicit_solver(const std::vector<MeshLevel>& levels, const Loading& loading,
                                                         const DynamicSettings& settings) {
  using Made = std::unique_ptr<DynamicSolver>;
  return in_precision(settings.solver.precision, [&]<class Real, class Stored>() -> Made {
    return std::make_unique<ImplicitSolverOf<HostExecutor, SolverTypes<HostExecutor, Real, Stored>>>(levels, loading,
                                                                                                     settings);
  });
}

}  // namespace physgen::fem
