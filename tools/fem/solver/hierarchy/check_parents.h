// The nodes of a level must hang on nodes of the next coarser one. For hierarchy.cpp.
#pragma once

#include <fem/solver/mesh_level.h>
#include <physgen/error.h>

#include <algorithm>
#include <string>
#include <type_traits>

namespace physgen::fem::detail {

/// @throw Error when a node has no parents on the next coarser level, or is prescribed where they are free
template <class Parents>
void check_parents(std::size_t l, const MeshLevel& level, const MeshLevel& coarser,
                   const std::vector<Parents>& parents) {
  const auto nodes_of = [](const Parents& p) -> const auto& {
    if constexpr (std::is_same_v<Parents, GridLocation>) {
      return p.nodes;
    } else {
      return p;
    }
  };
  const Index coarse_nodes = coarser.mesh.nodes;
  const auto outside = [&](const Parents& p) {
    return std::ranges::any_of(nodes_of(p), [&](Index n) { return n < 0 || n >= coarse_nodes; });
  };
  if (parents.size() != level.rest.size() || std::ranges::any_of(parents, outside)) {
    throw Error("level " + std::to_string(l) + ": every node needs parents among the " + std::to_string(coarse_nodes) +
                " nodes of the next coarser level");
  }
  if (coarser.is_grid()) return;  // whose stiffness is without what is prescribed
  for (std::size_t a = 0; a < parents.size(); ++a) {
    for (const Index p : nodes_of(parents[a])) {
      if ((level.fixed[a] & ~coarser.fixed[static_cast<std::size_t>(p)]) == 0) continue;
      throw Error("level " + std::to_string(l) + ": components of node " + std::to_string(a) +
                  " are prescribed that are free at its parent " + std::to_string(p) +
                  " on the next coarser level; prescribe them there, too");
    }
  }
}

}  // namespace physgen::fem::detail
