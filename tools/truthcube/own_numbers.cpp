#include "own_numbers.h"

#include <fem/mesh/follow_numbers.h>

namespace physgen::truthcube {

using fem::Index;

DrawnMesh::DrawnMesh(const Scene& scene) : rest(scene.levels.front().rest), tets(scene.levels.front().mesh.tets) {
  const auto& [nodes, order] = scene.numbers;
  if (nodes.empty()) return;
  own_rest = fem::in_old_order(rest, nodes);
  own_tets = fem::in_old_order(tets, order);
  for (auto& tet : own_tets) {
    for (Index& n : tet) n = nodes[static_cast<std::size_t>(n)];
  }
  rest = own_rest;
  tets = own_tets;
}

}  // namespace physgen::truthcube
