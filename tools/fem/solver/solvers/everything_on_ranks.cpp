#include <everything.halos.h>
#include <fem/solver/linear/performed_steps.h>
#include <fem/solver/solvers/everything_on_ranks.h>
#include <fem/solver/solvers/quasistatic_on_ranks.h>
#include <fem/solver/solvers/solvers_on_ranks.h>

namespace physgen::fem {

template <>
inline HaloUses halos_of<EverythingOnRanks<float, StoredInHalf>>() {
  return scenes::everything_scene::halos;
}
template <>
inline HaloUses halos_of<EverythingOnRanks<float, StoredAsComputed>>() {
  return scenes::everything_scene::halos;
}

std::unique_ptr<SolverOnRanks> make_everything_on_ranks(const Ranks& ranks, const std::vector<MeshLevel>& levels,
                                                        const Loading& loading, const SolverSettings& settings,
                                                        std::optional<index_t> replicated,
                                                        const DistributedOptions& options) {
  const auto make = [&]<class Scene>() {
    return std::make_unique<QuasistaticOnRanks<DistributedExecutor<HostExecutor>, Scene>>(
        ranks, WholeBody<Scene>(ranks, levels, loading, settings, replicated), settings, options);
  };
  std::unique_ptr<SolverOnRanks> made;
  if (settings.precision == TangentPrecision::half) {
    made = make.template operator()<EverythingOnRanks<float, StoredInHalf>>();
  } else {
    made = make.template operator()<EverythingOnRanks<float, StoredAsComputed>>();
  }
  return made;
}

}  // namespace physgen::fem
