// The arrays of solvers that run one scene each: with the fields alone that its program needs, in float.
#pragma once

#include <fem/materials/fixed_corotated.h>
#include <fem/materials/stable_neo_hookean.h>
#include <fem/solver/arrays/run_time_choices.h>
#include <fem/solver/elastic/equilibrium_arrays.h>
#include <fem/solver/elastic/evaluate.h>
#include <fem/solver/levels/linear_level.h>
#include <fem/solver/settings.h>
#include <implicit_dynamics.scene.h>
#include <quasistatic.scene.h>
#include <quasistatic_fixed_corotated.scene.h>
#include <quasistatic_matrix_free.scene.h>

#include <memory>

namespace physgen::fem {

/// A level without extra arrays of preconditioners, planes and inertia. @tparam Group Level of a scene
template <class Choices, class Group>
using SceneLevel =
    LevelOver<float, typename Group::Space, StoredAsComputed, Choices, Group, NoArrays, NoArrays, NoArrays>;

/// The arrays of the scene quasistatic, under the names of AllArrays.
template <class Space_>
struct QuasistaticArrays {
  using Real = float;
  using Space = Space_;
  using Law = StableNeoHookean<double>;
  using Arrays = EquilibriumOver<Real, scenes::quasistatic_scene::Body<Space>,
                                 PatchesOver<scenes::quasistatic_scene::Patches<Space>>, NoArrays,
                                 scenes::quasistatic_scene::Chunk<Space>>;
  using Level = SceneLevel<AssembledOnMeshes, scenes::quasistatic_scene::Level<Space, Real, StoredAsComputed>>;
  using Vectors = scenes::quasistatic_scene::Krylov<Space>;
};

/// The arrays of the scene quasistatic_matrix_free.
template <class Space_>
struct MatrixFreeArrays {
  using Real = float;
  using Space = Space_;
  using Law = StableNeoHookean<double>;
  using Arrays = EquilibriumOver<Real, scenes::quasistatic_matrix_free_scene::Body<Space>,
                                 PatchesOver<scenes::quasistatic_matrix_free_scene::Patches<Space>>, NoArrays,
                                 scenes::quasistatic_matrix_free_scene::Chunk<Space>>;
  using Level = SceneLevel<ByTets, scenes::quasistatic_matrix_free_scene::Level<Space, Real, StoredAsComputed>>;
  using Vectors = scenes::quasistatic_matrix_free_scene::Krylov<Space>;
};

/// The arrays of the scene quasistatic_fixed_corotated.
template <class Space_>
struct FixedCorotatedArrays {
  using Real = float;
  using Space = Space_;
  using Law = FixedCorotated<double>;
  using Arrays = EquilibriumOver<Real, scenes::quasistatic_fixed_corotated_scene::Body<Space>, NoArrays, NoArrays,
                                 scenes::quasistatic_fixed_corotated_scene::Chunk<Space>>;
  using Level =
      SceneLevel<AssembledOnMeshes, scenes::quasistatic_fixed_corotated_scene::Level<Space, Real, StoredAsComputed>>;
  using Vectors = scenes::quasistatic_fixed_corotated_scene::Krylov<Space>;
};

/// The arrays of the scene implicit_dynamics, whose volumes are those of tets where levels have no patches.
template <class Space_>
struct ImplicitDynamicsArrays {
  using Real = float;
  using Space = Space_;
  using Law = StableNeoHookean<double>;
  using Arrays = EquilibriumOver<Real, scenes::implicit_dynamics_scene::Body<Space>,
                                 PatchesOver<scenes::implicit_dynamics_scene::Patches<Space>>, NoArrays,
                                 scenes::implicit_dynamics_scene::Chunk<Space>>;
  using Level = LevelOver<Real, Space, StoredAsComputed, AssembledOnMeshes,
                          scenes::implicit_dynamics_scene::Level<Space, Real, StoredAsComputed>, NoArrays, NoArrays,
                          InertiaOver<scenes::implicit_dynamics_scene::Inertia<Space>>>;
  using Vectors = scenes::implicit_dynamics_scene::Krylov<Space>;
};

/// The types of a solver over arrays of a scene, for SolverOf and ImplicitSolverOf: in the material of the scene alone.
template <class SceneArrays>
struct SceneTypes : SceneArrays {
  using Material = MaterialSteps<typename SceneArrays::Law>;

  [[nodiscard]] static std::unique_ptr<Material> make_material(const SolverSettings& settings, bool averages) {
    return std::make_unique<Material>(SceneArrays::Law::from(settings.youngs_modulus, settings.poissons_ratio),
                                      averages);
  }
};

}  // namespace physgen::fem
