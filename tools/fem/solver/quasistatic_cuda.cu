// The solver on CUDA, in each precision.
#include <fem/solver/make_evaluator.h>
#include <fem/solver/product_cuda.h>
#include <fem/solver/schwarz_cuda.h>
#include <fem/solver/small_levels_cuda.h>
#include <fem/solver/solver_of.h>
#include <fem/solver/solvers.h>

namespace physgen::fem {

PHYSGEN_EVALUATORS_ARE_COMPILED_ELSEWHERE(CudaExecutor, float, Cuda)
PHYSGEN_EVALUATORS_ARE_COMPILED_ELSEWHERE(CudaExecutor, double, Cuda)

std::unique_ptr<QuasistaticSolver> make_cuda_solver(const std::vector<MeshLevel>& levels, const Loading& loading,
                                                    const SolverSettings& settings) {
  switch (settings.precision) {
    case TangentPrecision::half:
      return std::make_unique<SolverOf<CudaExecutor, float, StoredInHalf>>(levels, loading, settings);
    case TangentPrecision::float32:
      return std::make_unique<SolverOf<CudaExecutor, float, StoredAsComputed>>(levels, loading, settings);
    case TangentPrecision::float64:
      break;
  }
  return std::make_unique<SolverOf<CudaExecutor, double, StoredAsComputed>>(levels, loading, settings);
}

std::string cuda_device_name() {
  int device = 0;
  cudaDeviceProp properties{};
  cuda::check(cudaGetDevice(&device), "asking for the current device");
  cuda::check(cudaGetDeviceProperties(&properties, device), "asking for its name");
  return properties.name;
}

}  // namespace physgen::fem
