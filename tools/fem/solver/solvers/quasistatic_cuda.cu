// The solvers by Newton's method on CUDA, in each precision.
#include <fem/solver/linear/performed_steps.h>
#include <fem/solver/solvers/implicit_solver_of.h>
#include <fem/solver/solvers/in_precision.h>
#include <fem/solver/solvers/make_evaluator.h>
#include <fem/solver/solvers/solver_of.h>
#include <fem/solver/solvers/solver_types.h>
#include <fem/solver/solvers/solvers.h>

namespace physgen::fem {

PHYSGEN_EVALUATORS_ARE_COMPILED_ELSEWHERE(CudaExecutor, float, Cuda)
PHYSGEN_EVALUATORS_ARE_COMPILED_ELSEWHERE(CudaExecutor, double, Cuda)

std::unique_ptr<QuasistaticSolver> make_cuda_solver(const std::vector<MeshLevel>& levels, const Loading& loading,
                                                    const SolverSettings& settings) {
  using Made = std::unique_ptr<QuasistaticSolver>;
  return in_precision(settings.precision, [&]<class Real, class Stored>() -> Made {
    return std::make_unique<SolverOf<CudaExecutor, SolverTypes<CudaExecutor, Real, Stored>>>(levels, loading, settings);
  });
}

std::unique_ptr<DynamicSolver> make_cuda_implicit_solver(const std::vector<MeshLevel>& levels, const Loading& loading,
                                                         const DynamicSettings& settings) {
  using Made = std::unique_ptr<DynamicSolver>;
  return in_precision(settings.solver.precision, [&]<class Real, class Stored>() -> Made {
    return std::make_unique<ImplicitSolverOf<CudaExecutor, SolverTypes<CudaExecutor, Real, Stored>>>(levels, loading,
                                                                                                     settings);
  });
}

std::string cuda_device_name() {
  int device = 0;
  cudaDeviceProp properties{};
  cuda::check(cudaGetDevice(&device), "asking for the current device");
  cuda::check(cudaGetDeviceProperties(&properties, device), "asking for its name");
  return properties.name;
}

}  // namespace physgen::fem
