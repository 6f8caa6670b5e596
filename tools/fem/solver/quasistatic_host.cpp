// The solver on the CPU, in each precision.
#include <fem/solver/implicit_solver_of.h>
#include <fem/solver/linear_solver_of.h>
#include <fem/solver/make_evaluator.h>
#include <fem/solver/performed_steps.h>
#include <fem/solver/solver_of.h>
#include <fem/solver/solver_types.h>
#include <fem/solver/solvers.h>

namespace physgen::fem {

PHYSGEN_EVALUATORS_ARE_COMPILED_ELSEWHERE(HostExecutor, float, Host)
PHYSGEN_EVALUATORS_ARE_COMPILED_ELSEWHERE(HostExecutor, double, Host)

namespace {

/// Calls make.operator()<Real, Stored>() for a precision.
template <class Make>
auto in_precision(TangentPrecision precision, const Make& make) {
  switch (precision) {
    case TangentPrecision::half:
      return make.template operator()<float, StoredInHalf>();
    case TangentPrecision::float32:
      return make.template operator()<float, StoredAsComputed>();
    case TangentPrecision::float64:
      break;
  }
  return make.template operator()<double, StoredAsComputed>();
}

}  // namespace

std::unique_ptr<QuasistaticSolver> make_host_solver(const std::vector<MeshLevel>& levels, const Loading& loading,
                                                    const SolverSettings& settings) {
  using Made = std::unique_ptr<QuasistaticSolver>;
  return in_precision(settings.precision, [&]<class Real, class Stored>() -> Made {
    return std::make_unique<SolverOf<HostExecutor, SolverTypes<HostExecutor, Real, Stored>>>(levels, loading, settings);
  });
}

std::unique_ptr<EquilibriumSolver> make_host_linear_solver(const std::vector<MeshLevel>& levels, const Loading& loading,
                                                           const SolverSettings& settings) {
  using Made = std::unique_ptr<EquilibriumSolver>;
  return in_precision(settings.precision, [&]<class Real, class Stored>() -> Made {
    return std::make_unique<LinearSolverOf<HostExecutor, AllArrays<Real, Host, Stored>>>(levels, loading, settings);
  });
}

std::unique_ptr<DynamicSolver> make_host_implicit_solver(const std::vector<MeshLevel>& levels, const Loading& loading,
                                                         const DynamicSettings& settings) {
  using Made = std::unique_ptr<DynamicSolver>;
  return in_precision(settings.solver.precision, [&]<class Real, class Stored>() -> Made {
    return std::make_unique<ImplicitSolverOf<HostExecutor, Real, Stored>>(levels, loading, settings);
  });
}

}  // namespace physgen::fem
