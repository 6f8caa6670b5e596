// The solver's arrays with all that any choice at run time asks for: over the groups of the scene everything.
#pragma once

#include <everything.scene.h>
#include <fem/solver/elastic/equilibrium_arrays.h>
#include <fem/solver/levels/linear_level.h>
#include <fem/solver/preconditioners/extra_arrays.h>

namespace physgen::fem {

template <class Real, class Space>
using EquilibriumArrays = EquilibriumOver<Real, scenes::everything_scene::Body<Space, Real>,
                                          PatchesOver<scenes::everything_scene::Patches<Space, Real>>,
                                          RingsOver<scenes::everything_scene::Rings<Space, Real>>,
                                          scenes::everything_scene::Chunk<Space, Real, StoredAsComputed>,
                                          SurfaceOver<scenes::everything_scene::Surface<Space, Real>>>;

/// @tparam Stored StoredAsComputed or StoredInHalf
template <class Real, class Space, class Stored>
using LinearLevel = LevelOver<Real, Space, Stored, AnyChoice, scenes::everything_scene::Level<Space, Real, Stored>,
                              ExtraOver<scenes::everything_scene::Schwarz<Space, Real, Stored>>,
                              PlanesOver<scenes::everything_scene::Planes<Space, Real>>,
                              InertiaOver<scenes::everything_scene::Inertia<Space, Real>>>;

template <class Real, class Space>
using KrylovVectors = scenes::everything_scene::Krylov<Space, Real>;

/// All of them, by name.
template <class Real_, class Space_, class Stored>
struct AllArrays {
  using Real = Real_;
  using Space = Space_;
  using Arrays = EquilibriumArrays<Real, Space>;
  using Level = LinearLevel<Real, Space, Stored>;
  using Vectors = KrylovVectors<Real, Space>;
};

}  // namespace physgen::fem
