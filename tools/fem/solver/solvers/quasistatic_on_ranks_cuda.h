// In a build with CUDA, the solver on several ranks that each have a device.
#pragma once

#include <fem/solver/solvers/solver_on_ranks.h>
#include <fem/solver/solvers/whole_body.h>
#include <physgen/distributed/options.h>
#include <physgen/distributed/ranks.h>

#include <memory>

namespace physgen::fem {

/// As make_solver_on_ranks(), of the scene quasistatic.
[[nodiscard]] std::unique_ptr<SolverOnRanks> make_cuda_quasistatic_on_ranks(const Ranks& ranks,
                                                                            WholeBody<scenes::quasistatic> whole,
                                                                            const SolverSettings& settings,
                                                                            const DistributedOptions& options);

}  // namespace physgen::fem
