// The materials for the scene everything on several ranks.
#include <fem/solver/solvers/everything_on_ranks.h>
#include <fem/solver/solvers/make_evaluator.h>

namespace physgen::fem {

using OnRanks = DistributedExecutor<HostExecutor>;
template std::unique_ptr<Evaluator<OnRanks, EquilibriumOnRanks<float, Host>>>
make_evaluator<OnRanks, EquilibriumOnRanks<float, Host>>(const std::string&, const std::vector<ElasticConstants>&,
                                                         bool);

}  // namespace physgen::fem
