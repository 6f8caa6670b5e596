// Checks of products by rows of nodes, the same for CPU and CUDA.
#pragma once

#include <fem/solver/preconditioners/multigrid/row_product.h>
#include <fem/solver/preconditioners/multigrid/smoother.h>

#include "symmetric_product_checks.h"

namespace physgen::fem {

/// Each block at its two entries: as it is for m, transposed for n.
template <class FromView, class ToView>
struct CopyEdgeStiffness {
  using Scalar = typename ToView::Precision;
  FromView from;
  ToView to;
  PHYSGEN_FUNCTION void operator()(index_t edge, index_t entry, int side) const {
    Matrix3<Scalar> E = from[edge].E();
    if (side != 0) E = Matrix3<Scalar>(E.transpose());
    to[entry].E() = E;
  }
};
template <class... Views>
CopyEdgeStiffness(Views...) -> CopyEdgeStiffness<Views...>;

/// df = what the nodes have of K dx.
template <class StiffnessView, class DisplacementView, class DifferentialView>
struct BeginWithNodes {
  using Scalar = typename DifferentialView::Precision;
  StiffnessView stiffness;
  DisplacementView displacements;
  DifferentialView differentials;
  PHYSGEN_FUNCTION void operator()(index_t node) const {
    const Vector3<Scalar> dx = displacements[node].dx();
    differentials[node].df() = Vector3<Scalar>(Vector3<Scalar>::Zero());
    add_node_product<Scalar>(stiffness, differentials, node, dx);
  }
};
template <class... Views>
BeginWithNodes(Views...) -> BeginWithNodes<Views...>;

/// @param on an executor of Space
template <class Real, class Space, class On>
void check_products_by_rows(On& on) {
  constexpr unsigned stream = 13;
  for (TetMesh& mesh : product_meshes()) {
    ProductScene<Real, Space, Aosoa<32>> scene(std::move(mesh), stream);
    const EdgeRows rows(scene.mesh, Space::kind);
    const auto edges = static_cast<index_t>(scene.mesh.edges.size());
    elasticity::IncidenceRangeArray<float, Space> ranges(scene.mesh.nodes);
    quasistatic::PackedIncidenceArray<float, Space> entries(2 * edges);
    put_packed<NodeEdgeEntry>(ranges, entries, scene.mesh.node_edges, edges, "edges");
    Array<elasticity::EdgeStiffnessObject, Real, Space, Aosoa<32>> blocks(2 * edges);
    const CopyEdgeStiffness copy{scene.edge_stiffness.const_view(), blocks.view()};
    on.run(2 * edges, AtEntries{copy, entries.const_view()});
    const auto x = scene.displacements.const_view();
    const auto y = scene.differentials.view();
    const auto multiply = [&] {
      on.run(scene.mesh.nodes, BeginWithNodes{scene.node_stiffness.const_view(), x, y});
      run_rows(on, scene.mesh.nodes, AddRowProduct{rows.view(), blocks.const_view(), x, y});
    };
    multiply();
    on.wait();
    scene.expect_right();
    const auto first = scene.result();
    scene.poison();
    multiply();
    on.wait();
    const auto second = scene.result();
    EXPECT_EQ(
        std::memcmp(first.untyped().base, second.untyped().base, static_cast<std::size_t>(first.untyped().bytes())), 0)
        << "the same bits on every run";
  }
}

}  // namespace physgen::fem
