// The arrays of the solver of linear elastic bodies, which are those of two scenes, in each precision.
#pragma once

#include <fem/solver/arrays/run_time_choices.h>
#include <fem/solver/levels/linear_level.h>
#include <fem/solver/preconditioners/extra_arrays.h>
#include <linear_elastic.scene.h>
#include <linear_elastic_assembled.scene.h>

namespace physgen::fem {

/// The arrays of the scene linear_elastic_assembled. @tparam Stored StoredAsComputed or StoredInHalf
template <class Real_, class Space_, class Stored>
struct LinearAssembledArrays {
  using Real = Real_;
  using Space = Space_;
  using Body = scenes::linear_elastic_assembled_scene::Linear<Space, Real>;
  using Level =
      LevelOver<Real, Space, Stored, AssembledAnywhere,
                scenes::linear_elastic_assembled_scene::Level<Space, Real, Stored>,
                ExtraOver<scenes::linear_elastic_assembled_scene::Schwarz<Space, Real, Stored>>, NoArrays, NoArrays>;
  using Vectors = scenes::linear_elastic_assembled_scene::Krylov<Space, Real>;
};

/// The arrays of the scene linear_elastic, whose products are matrix-free.
template <class Real_, class Space_>
struct LinearByTetsArrays {
  using Real = Real_;
  using Space = Space_;
  using Body = scenes::linear_elastic_scene::Linear<Space, Real>;
  using Level =
      LevelOver<Real, Space, StoredAsComputed, ByTets,
                scenes::linear_elastic_scene::Level<Space, Real, StoredAsComputed>, NoArrays, NoArrays, NoArrays>;
  using Vectors = scenes::linear_elastic_scene::Krylov<Space, Real>;
};

}  // namespace physgen::fem
