// What the rows of the product with the assembled stiffness share.
#pragma once

#include <fem/symmetric_product.h>

#include "kernels.h"

namespace physgen::bench {

/// Inputs and output in one space, and the lists of sums.
template <class Real, class Space>
struct SymmetricOperands {
  elasticity::NodeStiffnessArray<Real, Space> node_stiffness;
  elasticity::EdgeStiffnessArray<Real, Space> edge_stiffness;
  elasticity::EdgeArray<Real, Space> edges;
  elasticity::NodeDisplacementArray<Real, Space> displacements;
  elasticity::NodeForceDifferentialArray<Real, Space> differentials;
  fem::EdgeSums sums;

  explicit SymmetricOperands(Dataset& data)
      : node_stiffness(data.node_stiffness().size()),
        edge_stiffness(data.edge_stiffness().size()),
        edges(data.edges().size()),
        displacements(data.displacements().size()),
        differentials(data.displacements().size()),
        sums(data.mesh(), Space::kind, sizeof(Real)) {
    physgen::copy(node_stiffness, data.node_stiffness());
    physgen::copy(edge_stiffness, data.edge_stiffness());
    physgen::copy(edges, data.edges());
    physgen::copy(displacements, data.displacements());
    if constexpr (!host_accessible(Space::kind)) synchronize();
  }
  [[nodiscard]] auto product() {
    return fem::SymmetricProduct{node_stiffness.const_view(), edge_stiffness.const_view(), edges.const_view(),
                                 displacements.const_view(), differentials.view()};
  }
};

/// The row of such a product: bytes are those of the symmetric half, its indices, and the vectors.
template <class Real>
Row symmetric_row(const char* layout, SpaceKind space, const Dataset& data) {
  Row row = describe<AddForceDifferential, Real>(layout, space, data);
  const MeshSizes n = data.sizes(Domain::nodes);
  row.bytes_per_object = (n.edges * (8 + 9 * sizeof(Real)) + n.nodes * 12 * sizeof(Real)) / n.nodes;
  return row;
}

}  // namespace physgen::bench
