// The arrays of volumes that are averaged at nodes, by name.
#pragma once

#include <fem/mesh/rings.h>
#include <fem/solver/solver_arrays.h>

namespace physgen::fem {

template <class Real, class Space>
struct RingArrays {
  using Rows = RowArrays<elasticity::IncidenceRangeArray<float, Space>, quasistatic::RingNodeArray<Real, Space>>;

  Rows nodes;                                                ///< per node: those of its ring, ascending
  quasistatic::NodeVolumeTangentArray<Real, Space> tangent;  ///< per node

  explicit RingArrays(const TetMesh& mesh) : nodes(host_rings(make_rings(mesh))), tangent(mesh.nodes) {}

  [[nodiscard]] index_t bytes() const { return bytes_of(nodes.ranges(), nodes.entries(), tangent); }

 private:
  using HostRows = typename RingArrays<Real, Host>::Rows;
  static HostRows host_rings(const NodeRings& rings) {
    std::vector<typename HostRows::Value> entries(rings.nodes.size());
    for (std::size_t k = 0; k < entries.size(); ++k) entries[k].node = rings.nodes[k];
    return HostRows::from_offsets({"node", index_t(rings.first.size()) - 1}, rings.first, entries);
  }
};

}  // namespace physgen::fem
