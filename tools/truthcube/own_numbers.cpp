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

Fields in_own_order(Fields fields, const fem::Renumbering& numbers) {
  const auto& [nodes, tets] = numbers;
  if (nodes.empty()) return fields;
  const auto put = [](std::vector<double>& values, const std::vector<Index>& order, std::size_t each) {
    values = fem::in_old_order(std::span<const double>(values), std::span(order), each);
  };
  put(fields.displacement, nodes, 3);
  put(fields.pressure, nodes, 1);
  put(fields.stress, tets, 6);
  put(fields.von_mises, tets, 1);
  put(fields.volume_ratio, tets, 1);
  return fields;
}

}  // namespace physgen::truthcube
