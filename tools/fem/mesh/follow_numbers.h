// What belongs to a mesh follows its new numbers (renumber.h): finer meshes, patches, groups, values of nodes and tets.
#pragma once

#include <fem/mesh/groups.h>
#include <fem/mesh/patches.h>
#include <fem/mesh/renumber.h>

#include <array>
#include <span>
#include <vector>

namespace physgen::fem {

/// The new number of each old one. @pre the order names each old number once
[[nodiscard]] std::vector<Index> new_numbers(std::span<const Index> order);

/// values[order[0]], values[order[1]], ...
template <class Value>
[[nodiscard]] std::vector<Value> in_order(std::span<const Value> values, std::span<const Index> order) {
  std::vector<Value> result;
  result.reserve(order.size());
  for (const Index old : order) result.push_back(values[static_cast<std::size_t>(old)]);
  return result;
}

/// The reverse of in_order(): the values of new numbers under the old ones, `each` for every number.
template <class Value>
[[nodiscard]] std::vector<Value> in_old_order(std::span<const Value> values, std::span<const Index> order,
                                              std::size_t each = 1) {
  std::vector<Value> result(values.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t k = 0; k < each; ++k) result[each * static_cast<std::size_t>(order[i]) + k] = values[each * i + k];
  }
  return result;
}

/// Numbers of the mesh that refine() makes of one, so that it lies along the coarse mesh's new numbers: a node of the
/// coarse mesh stands before the midpoints of its edges to higher nodes, and the eight parts of tets stay together.
/// @param coarse of the coarse mesh @param parents as refine() gives them, in old numbers
[[nodiscard]] Renumbering refined_numbers(const Renumbering& coarse, std::span<const std::array<Index, 2>> parents);

struct RenumberedPatches {
  VolumePatches patches;
  std::vector<Index> order;  ///< new patch p is old patch order[p]
};

/// The same patches of tets under new numbers, in the order of their lowest new tets.
[[nodiscard]] RenumberedPatches renumbered(const VolumePatches& patches, const Renumbering& numbers);

/// The same group under new numbers.
/// @param mesh under new numbers
[[nodiscard]] MeshGroup renumbered(const MeshGroup& group, const TetMesh& mesh, const Renumbering& numbers);

}  // namespace physgen::fem
