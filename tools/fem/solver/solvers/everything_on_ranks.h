// What several ranks have of the scene everything: every material, volumes of tets or patches, an assembled stiffness
// in each precision, background grids, and rigid planes; on the CPU.
#pragma once

#include <everything.scene.h>
#include <fem/solver/solvers/scene_types.h>
#include <physgen/distributed/executor.h>

#include <memory>

namespace physgen::fem {

/// Names the arrays of the scene everything where others are named by a scene with a row: see SceneArrays.
/// @tparam Real of the tangent @tparam Stored how preconditioners store their matrices
template <class Real, class Stored>
struct EverythingOnRanks {};

template <class Real, class Space>
using EquilibriumOnRanks = EquilibriumOver<Real, scenes::everything_scene::Body<Space, Real>,
                                           PatchesOver<scenes::everything_scene::Patches<Space, Real>>, NoArrays,
                                           scenes::everything_scene::Chunk<Space, Real, StoredAsComputed>>;

template <class Real_, class Stored, class Space_>
struct SceneArrays<EverythingOnRanks<Real_, Stored>, Space_> {
  using Real = Real_;
  using Space = Space_;
  using Arrays = EquilibriumOnRanks<Real, Space>;
  using Level = LevelOver<Real, Space, Stored, AssembledAnywhere, scenes::everything_scene::Level<Space, Real, Stored>,
                          NoArrays, PlanesOver<scenes::everything_scene::Planes<Space, Real>>, NoArrays>;
  using Vectors = scenes::everything_scene::Krylov<Space, Real>;
};

/// The types of a solver over these arrays, in each material.
template <class Real, class Stored, class Space>
struct SceneTypes<SceneArrays<EverythingOnRanks<Real, Stored>, Space>>
    : SceneArrays<EverythingOnRanks<Real, Stored>, Space> {
  using On = DistributedExecutor<HostExecutor>;
  using Material = Evaluator<On, EquilibriumOnRanks<Real, Space>>;

  [[nodiscard]] static std::unique_ptr<Material> make_material(const SolverSettings& settings, bool averages) {
    return make_evaluator<On, EquilibriumOnRanks<Real, Space>>(settings.material, constants_of(settings), averages);
  }
};

}  // namespace physgen::fem
