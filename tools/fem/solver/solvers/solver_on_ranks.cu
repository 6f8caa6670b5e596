// The solver of several ranks on CUDA, each with a device.
#include <fem/solver/linear/performed_steps.h>
#include <fem/solver/solvers/quasistatic_on_ranks.h>

namespace physgen::fem {

std::unique_ptr<SolverOnRanks> make_cuda_solver_on_ranks(const Ranks& ranks, const WholeBody& whole,
                                                         const SolverSettings& settings,
                                                         std::optional<index_t> replicated,
                                                         const DistributedOptions& options) {
  return std::make_unique<QuasistaticOnRanks<DistributedExecutor<CudaExecutor>>>(ranks, whole, settings, replicated,
                                                                                 options);
}

}  // namespace physgen::fem
