// The arrays of volumes that are averaged at nodes, by name.
#pragma once

#include <fem/mesh/rings.h>
#include <fem/solver/arrays/over_groups.h>
#include <fem/solver/arrays/solver_arrays.h>
#include <fem/solver/hierarchy/level_counts.h>

#include <utility>

namespace physgen::fem {

/// @tparam Group with the arrays of Rings in solver_groups.h
template <class Group>
struct RingsOver : Group {
  RowsOf<decltype(Group::node_ranges), decltype(Group::node_entries)> nodes{this->node_ranges, this->node_entries};

  explicit RingsOver(Group&& arrays) : Group(std::move(arrays)) {}
  RingsOver(const TetMesh& mesh, const LevelCounts& of_mesh) {
    this->allocate(counts(of_mesh));
    const NodeRings rings = make_rings(mesh);
    put_each(this->node_ranges, [&](index_t n, auto&& range) {
      range.begin() = rings.first[std::size_t(n)];
      range.end() = rings.first[std::size_t(n) + 1];
    });
    put_each(this->node_entries, [&](index_t k, auto&& entry) { entry.node() = rings.nodes[std::size_t(k)]; });
  }

  [[nodiscard]] static auto counts(const LevelCounts& mesh) {
    return typename Group::Counts{.node = mesh.nodes, .neighbour = mesh.ring_nodes};
  }
};

}  // namespace physgen::fem
