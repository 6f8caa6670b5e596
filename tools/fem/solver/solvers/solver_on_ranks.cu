// The solver of several ranks on CUDA, each with a device.
#include <fem/solver/linear/performed_steps.h>
#include <fem/solver/solvers/quasistatic_on_ranks.h>

namespace physgen::fem {

std::unique_ptr<SolverOnRanks> make_cuda_solver_on_ranks(const Ranks& ranks, WholeBody whole,
                                                         const SolverSettings& settings,
                                                         const DistributedOptions& options) {
  return std::make_unique<QuasistaticOnRanks<DistributedExecutor<CudaExecutor>>>(ranks, std::move(whole), settings,
                                                                                 options);
}

}  // namespace physgen::fem
