// The arrays of the solver as probes: the groups of the scene everything, with a probe in place of each array.
#pragma once

#include <everything.scene.h>
#include <fem/solver/elastic/equilibrium_arrays.h>
#include <fem/solver/levels/linear_level.h>
#include <physgen/probe.h>

#include <memory>

namespace physgen::fem::test {

/// A probe of each array that Stored has, under the array's own name.
template <class Stored>
struct Probed {
  template <class Tag, class Array>
  using Of = ProbeOf<StoredArray<Stored, Tag, Array>, Tag>;
};

template <class Real, class Space>
struct ProbeEquilibrium
    : EquilibriumOver<Real, scenes::everything_scene::Body<Space, Real, Probed<StoredAsDeclared>>,
                      PatchesOver<scenes::everything_scene::Patches<Space, Real, Probed<StoredAsDeclared>>>,
                      RingsOver<scenes::everything_scene::Rings<Space, Real, Probed<StoredAsDeclared>>>,
                      scenes::everything_scene::Chunk<Space, Real, Probed<StoredAsDeclared>>,
                      SurfaceOver<scenes::everything_scene::Surface<Space, Real, Probed<StoredAsDeclared>>>> {
  using Body = scenes::everything_scene::Body<Space, Real, Probed<StoredAsDeclared>>;
  ProbeEquilibrium() : ProbeEquilibrium::EquilibriumOver(Body()) {
    this->chunks = {{0, 1, 0, 1, 0, 1}};
    this->chunk_arrays = std::make_shared<scenes::everything_scene::Chunk<Space, Real, Probed<StoredAsDeclared>>>();
  }
};

template <class Space, class Real>
using ProbeInertia = InertiaOver<scenes::everything_scene::Inertia<Space, Real, Probed<StoredAsDeclared>>>;

template <class Real, class Space, class Stored>
using ProbeLevel =
    LevelOver<Real, Space, Stored, AnyChoice, scenes::everything_scene::Level<Space, Real, Probed<Stored>>,
              SchwarzOver<scenes::everything_scene::Schwarz<Space, Real, Probed<Stored>>>,
              PlanesOver<scenes::everything_scene::Planes<Space, Real, Probed<StoredAsDeclared>>>,
              ProbeInertia<Space, Real>>;

template <class Real, class Space>
using ProbeVectors = scenes::everything_scene::Krylov<Space, Real, Probed<StoredAsDeclared>>;

}  // namespace physgen::fem::test
