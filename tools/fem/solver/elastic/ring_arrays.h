// The arrays of volumes that are averaged at nodes, by name.
#pragma once

#include <fem/mesh/rings.h>
#include <fem/solver/arrays/over_groups.h>
#include <fem/solver/arrays/solver_arrays.h>
#include <fem/solver/hierarchy/level_counts.h>

#include <utility>
#include <vector>

namespace physgen::fem {

/// @tparam Group with the arrays of Rings in solver_groups.h
template <class Group>
struct RingsOver : Group {
  RowsOf<decltype(Group::node_ranges), decltype(Group::node_entries)> nodes{this->node_ranges, this->node_entries};

  explicit RingsOver(Group&& arrays) : Group(std::move(arrays)) {}
  RingsOver(const TetMesh& mesh, const LevelCounts& of_mesh) {
    const auto rings = host_rings(make_rings(mesh));
    this->allocate(counts(of_mesh));
    put(this->node_ranges, rings.ranges());
    put(this->node_entries, rings.entries());
  }

  [[nodiscard]] static auto counts(const LevelCounts& mesh) {
    return typename Group::Counts{.node = mesh.nodes, .neighbour = mesh.ring_nodes};
  }

 private:
  using HostRows = RowArrays<elasticity::IncidenceRangeArray<float>, quasistatic::RingNodeArray<typename Group::Real>>;
  static HostRows host_rings(const NodeRings& rings) {
    std::vector<typename HostRows::Value> entries(rings.nodes.size());
    for (std::size_t k = 0; k < entries.size(); ++k) entries[k].node = rings.nodes[k];
    return HostRows::from_offsets({"node", index_t(rings.first.size()) - 1}, rings.first, entries);
  }
};

}  // namespace physgen::fem
