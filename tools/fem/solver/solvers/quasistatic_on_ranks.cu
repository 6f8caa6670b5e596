#include <fem/solver/linear/performed_steps.h>
#include <fem/solver/solvers/quasistatic_on_ranks.h>
#include <fem/solver/solvers/quasistatic_on_ranks_cuda.h>
#include <quasistatic.halos.h>

#include <utility>

namespace physgen::fem {

template <>
inline HaloUses halos_of<scenes::quasistatic>() {
  return scenes::quasistatic_scene::halos;
}

std::unique_ptr<SolverOnRanks> make_cuda_quasistatic_on_ranks(const Ranks& ranks, WholeBody<scenes::quasistatic> whole,
                                                              const SolverSettings& settings,
                                                              const DistributedOptions& options) {
  using On = DistributedExecutor<CudaExecutor>;
  return std::make_unique<QuasistaticOnRanks<On, scenes::quasistatic>>(ranks, std::move(whole), settings, options);
}

}  // namespace physgen::fem
