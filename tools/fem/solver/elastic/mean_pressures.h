// Linearised pressures of volumes that are averaged over patches or at nodes: along a Newton step, and from a coarser
// level. None of these does anything where volumes are those of tets.
#pragma once

#include <fem/solver/arrays/over_groups.h>
#include <fem/solver/elastic/node_volume.h>
#include <fem/solver/elastic/patch_volume.h>

namespace physgen::fem {

/// Along with a step dx from the state that was evaluated last. @param dx view of elasticity::NodeDisplacement
/// @param evaluator of these arrays
template <class On, class Arrays, class Evaluate, class Displacements>
void advance_pressures(On& on, Arrays& a, const Evaluate& evaluator, const Displacements& dx) {
  const auto of_patches = [&](auto& p) {
    a.each_material([&](std::size_t m, const MaterialRange& range) {
      const VolumeTerm volume = evaluator.volume(m);
      on.run(a.volumes.size(), AdvancePatches{range, volume.law, volume.modulus, a.volumes.view(), p.nodes.const_view(),
                                              p.tangent.const_view(), dx});
    });
  };
  const auto at_nodes = [&](auto& rings) {
    const VolumeTerm volume = evaluator.volume(0);
    on.run(a.volumes.size(),
           AdvanceNodeVolumes{volume.law, volume.modulus, a.volumes.view(), rings.nodes.const_view(), dx});
  };
  if (!where(a.patches, of_patches)) where(a.rings, at_nodes);
}

/// Along with a part of the step, 0 to 1. @pre advance_pressures() for all of it
template <class On, class Arrays>
void shorten_pressures(On& on, Arrays& a, double length) {
  if constexpr (may_have<decltype(a.patches)> || may_have<decltype(a.rings)>) {
    if (a.volumes.size() != 0) on.run(a.volumes.size(), ShortenPressures{length, a.volumes.view()});
  }
}

/// To begin with, those that a coarser level has found. @return whether there are any
/// @param parents view of quasistatic::NodeParents, to the coarser level
template <class On, class Arrays, class Parents>
[[nodiscard]] bool inject_pressures(On& on, const Arrays& coarse, Arrays& a, const Parents& parents) {
  bool injected = false;
  where(a.patches, [&](auto& p) {
    if (p.parents.size() == 0) return;
    on.run(a.volumes.size(),
           InjectPatchPressures{p.parents.const_view(), coarse.volumes.const_view(), a.volumes.view()});
    injected = true;
  });
  where(a.rings, [&](auto& /*rings*/) {
    on.run(a.volumes.size(), InjectNodePressures{parents, coarse.volumes.const_view(), a.volumes.view()});
    injected = true;
  });
  return injected;
}

}  // namespace physgen::fem
