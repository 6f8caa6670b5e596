// Kernels: change of the nodes' forces along a displacement differential, in assembled form (one pass over node and
// edge stiffness) and in element form (matrix-free, per tet, then gathered).
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/kernels/elastic_force.h>
#include <fem/kernels/stress_differential.h>
#include <fem/kernels/tet.h>

namespace physgen::fem {

/// df(v) = K_v dx(v) + sum over the edges of v of E dx(n), where v is m, and E^T dx(m), where v is n.
template <class NodeStiffnessView, class EdgeStiffnessView, class EdgeView, class NodeEdges, class DisplacementView,
          class DifferentialView>
struct ComputeForceDifferentials {
  using Scalar = typename DifferentialView::Precision;
  NodeStiffnessView node_stiffness;  ///< elasticity::NodeStiffness
  EdgeStiffnessView edge_stiffness;  ///< elasticity::EdgeStiffness
  EdgeView edges;                    ///< elasticity::Edge
  NodeEdges node_edges;              ///< Rows of elasticity::Incidence: edge, side
  DisplacementView displacements;    ///< elasticity::NodeDisplacement
  DifferentialView differentials;    ///< elasticity::NodeForceDifferential, written

  /// @throw Error when there is not a row for each node, or rows do not name these edges
  ComputeForceDifferentials(const NodeStiffnessView& node_blocks, const EdgeStiffnessView& edge_blocks,
                            const EdgeView& edge_nodes, const NodeEdges& rows, const DisplacementView& dx,
                            const DifferentialView& sums)
      : node_stiffness(node_blocks),
        edge_stiffness(edge_blocks),
        edges(edge_nodes),
        node_edges(rows),
        displacements(dx),
        differentials(sums) {
    node_edges.require("ComputeForceDifferentials: node_edges", differentials.size(), edges.size());
  }

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Vector = Vector3<Scalar>;
    const Matrix3<Scalar> K = node_stiffness[node].K();
    const Vector own = displacements[node].dx();
    const auto add_edge = [&](const Vector& sum, const auto& incidence) -> Vector {
      const index_t edge = incidence.element();
      const int side = incidence.local();
      const index_t other = edges[edge].nodes()[1 - side];
      const Matrix3<Scalar> E = edge_stiffness[edge].E();
      const Vector dx = displacements[other].dx();
      return side == 0 ? multiply_add<Scalar>(E, dx, sum) : transpose_multiply_add<Scalar>(E, dx, sum);
    };
    differentials[node].df() = node_edges.fold(node, multiply_add<Scalar>(K, own, Vector::Zero()), add_edge);
  }
};

/// dG = -volume dP(Ds(dx) Dm^-1) Dm^-T [N]: the element form, before its sum at the nodes.
template <class TetView, class DisplacementView, class RestView, class SvdView, class DerivativeView, class CornerView>
struct ComputeCornerForceDifferentials {
  using Scalar = typename CornerView::Precision;
  TetView tets;                    ///< elasticity::Tet
  DisplacementView displacements;  ///< elasticity::NodeDisplacement
  RestView rest;                   ///< elasticity::RestShape
  SvdView decomposition;           ///< elasticity::DeformationSvd, of which U and V are read
  DerivativeView derivative;       ///< elasticity::StressDerivative
  CornerView differentials;        ///< elasticity::CornerForces, written: their change

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const Matrix3<S> ds =
        detail::edge_matrix<Scalar>(tets, i, [this](auto node) { return displacements[node].dx().get(); });
    const auto shape = rest[i];
    const auto rotations = decomposition[i];
    const Matrix3<S> dm_inverse = shape.dm_inverse(), U = rotations.U(), V = rotations.V();
    const S volume = shape.volume();
    const Matrix3<S> dF = multiply<S>(ds, dm_inverse);
    const Matrix3<S> dP = detail::stress_differential<S>(U, V, derivative[i], dF);
    differentials[i].G() = detail::corner_forces<S>(dP, dm_inverse, volume);
  }
};

/// df(node) = sum over its tets.
template <class NodeTets, class CornerView, class NodeView>
struct GatherForceDifferentials {
  using Scalar = typename NodeView::Precision;
  NodeTets node_tets;        ///< Rows of elasticity::Incidence: tet, corner
  CornerView differentials;  ///< elasticity::CornerForces: their change
  NodeView nodes;            ///< elasticity::NodeForceDifferential, written

  /// @throw Error when there is not a row for each node, or rows do not name these tets
  GatherForceDifferentials(const NodeTets& rows, const CornerView& changes, const NodeView& sums)
      : node_tets(rows), differentials(changes), nodes(sums) {
    node_tets.require("GatherForceDifferentials: node_tets", nodes.size(), differentials.size());
  }

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    nodes[node].df() = detail::gather_corners<Scalar>(node_tets, differentials, node);
  }
};

}  // namespace physgen::fem

#pragma pop_macro("I")
