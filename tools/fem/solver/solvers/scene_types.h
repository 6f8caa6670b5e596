// The arrays of solvers that run one scene each: with the fields alone that its program needs, in float.
#pragma once

#include <fem/materials/materials.h>
#include <fem/solver/arrays/run_time_choices.h>
#include <fem/solver/elastic/equilibrium_arrays.h>
#include <fem/solver/elastic/evaluate.h>
#include <fem/solver/levels/linear_level.h>
#include <fem/solver/scene_rows.h>
#include <fem/solver/settings.h>
#include <solved_scenes.h>  // which CMake writes: the header of each row's arrays

#include <memory>

namespace physgen::fem {

/// The arrays of a row of scene_rows.h, under the names of AllArrays. @tparam Scene scenes::quasistatic, or another
template <class Scene, class Space>
struct SceneArrays;

#define PHYSGEN_PATCHES_by_patches(scene) PatchesOver<scenes::scene##_scene::Patches<Space_>>
#define PHYSGEN_PATCHES_by_either(scene) PHYSGEN_PATCHES_by_patches(scene)
#define PHYSGEN_PATCHES_by_tets(scene) NoArrays
#define PHYSGEN_SCENE_ARRAYS(scene, word, Material, Choices_, volumes, InertiaOf, ...)                                 \
  template <class Space_>                                                                                              \
  struct SceneArrays<scenes::scene, Space_> {                                                                          \
    using Real = float;                                                                                                \
    using Space = Space_;                                                                                              \
    using Law = Material<double>;                                                                                      \
    using Arrays = EquilibriumOver<Real, scenes::scene##_scene::Body<Space_>, PHYSGEN_PATCHES_##volumes(scene),        \
                                   NoArrays, scenes::scene##_scene::Chunk<Space_, Real, StoredAsComputed>>;            \
    using Level =                                                                                                      \
        LevelOver<Real, Space_, StoredAsComputed, Choices_,                                                            \
                  scenes::scene##_scene::Level<Space_, Real, StoredAsComputed>, NoArrays, NoArrays, InertiaOf(scene)>; \
    using Vectors = scenes::scene##_scene::Krylov<Space_>;                                                             \
  };
#define PHYSGEN_INERTIA_OF(scene) InertiaOver<scenes::scene##_scene::Inertia<Space_>>
#define PHYSGEN_NO_INERTIA_OF(scene) NoArrays
PHYSGEN_EQUILIBRIUM_SCENES(PHYSGEN_SCENE_ARRAYS, PHYSGEN_NO_INERTIA_OF)
PHYSGEN_IMPLICIT_SCENES(PHYSGEN_SCENE_ARRAYS, PHYSGEN_INERTIA_OF)
#undef PHYSGEN_INERTIA_OF
#undef PHYSGEN_NO_INERTIA_OF
#undef PHYSGEN_SCENE_ARRAYS
#undef PHYSGEN_PATCHES_by_patches
#undef PHYSGEN_PATCHES_by_either
#undef PHYSGEN_PATCHES_by_tets

/// The types of a solver over arrays of a scene, for SolverOf and ImplicitSolverOf: in the material of the scene alone.
/// @tparam Arrays_ SceneArrays
template <class Arrays_>
struct SceneTypes : Arrays_ {
  using Material = MaterialSteps<typename Arrays_::Law>;

  [[nodiscard]] static std::unique_ptr<Material> make_material(const SolverSettings& settings, bool averages) {
    return std::make_unique<Material>(constants_of(settings), averages);
  }
};

}  // namespace physgen::fem
