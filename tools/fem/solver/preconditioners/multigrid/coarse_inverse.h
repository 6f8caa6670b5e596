// The coarsest level, solved exactly: the product with a dense inverse, which product_host.h and product_cuda.h form
// once per tangent.
#pragma once

#include <fem/solver/free_part.h>
#include <fem/solver/row_sums.h>
#include <physgen/kernel.h>

#include <limits>

namespace physgen::fem {

namespace detail {

/// Pivots below are rounding, the diagonal being about 1: their components are left out of the inverse. Such are nodes
/// of a background grid on which the same few nodes hang, and which one of them can stand for.
template <class Scalar>
inline constexpr Scalar least_coarse_pivot = 32 * std::numeric_limits<Scalar>::epsilon();

/// A level's stiffness as it is solved for, in scaled unknowns and without prescribed components, times -1. Not what
/// smoothers use, which may be stored in half.
template <class NodeStiffnessView, class EdgeStiffnessView, class EdgeView, class ConstraintView, class ScaleView>
struct ScaledStiffness {
  using Scalar = typename NodeStiffnessView::Precision;
  NodeStiffnessView nodes;     ///< elasticity::NodeStiffness
  EdgeStiffnessView edges;     ///< elasticity::EdgeStiffness
  EdgeView ends;               ///< elasticity::Edge
  ConstraintView constraints;  ///< quasistatic::NodeConstraint
  ScaleView scales;            ///< quasistatic::NodeScale

  /// Calls put(row, column, block) with the node's block.
  template <class Put>
  PHYSGEN_FUNCTION void put_node(index_t node, const Put& put) const {
    const Scalar scale = scales[node].scale();
    const int fixed = constraints[node].fixed();
    const Matrix3<Scalar> K = Matrix3<Scalar>(nodes[node].K().get()) * (-scale * scale);
    put(node, node, free_block<Scalar>(K, fixed, fixed));
  }
  /// Calls put(row, column, block) with both blocks of the edge.
  template <class Put>
  PHYSGEN_FUNCTION void put_edge(index_t edge, const Put& put) const {
    const auto names = ends[edge].nodes();
    const index_t m = names[0], n = names[1];
    Matrix3<Scalar> E = edges[edge].E();
    E *= -Scalar(scales[m].scale()) * Scalar(scales[n].scale());
    E = free_block<Scalar>(E, constraints[m].fixed(), constraints[n].fixed());
    put(m, n, E);
    put(n, m, Matrix3<Scalar>(E.transpose()));
  }
};

template <class Level>
[[nodiscard]] auto scaled_stiffness(const Level& level) {
  return ScaledStiffness{level.node_stiffness.const_view(), level.edge_stiffness.const_view(), level.edges.const_view(),
                         level.constraints.const_view(), level.scales.const_view()};
}

/// What the inversion of a level uses.
template <class Stiffness, class InverseView>
struct InvertStiffness {
  Stiffness stiffness;  ///< ScaledStiffness
  InverseView inverse;  ///< quasistatic::CoarseInverse, written
};

template <class Level>
[[nodiscard]] auto inverse_of(Level& level) {
  return InvertStiffness{scaled_stiffness(level), level.coarse_inverse.view()};
}

}  // namespace detail

/// z of node i = sum over nodes j of G_ij r_j.
template <class InverseView, class ResidualView, class CorrectionView>
struct ApplyCoarseInverse {
  using Scalar = typename CorrectionView::Precision;
  index_t nodes;
  InverseView inverse;         ///< quasistatic::CoarseInverse
  ResidualView residual;       ///< elasticity::NodeForceDifferential
  CorrectionView corrections;  ///< elasticity::NodeDisplacement, written

  static constexpr int lanes = 32;  ///< see run_rows()

  PHYSGEN_FUNCTION Vector3<Scalar> part(SingleObject auto i, Lane lane) const {
    Vector3<Scalar> sum = Vector3<Scalar>::Zero();
    for (index_t j = lane.number; j < nodes; j += lane.count) {
      const Matrix3<Scalar> G = inverse[object_number(i) * nodes + j].G();
      const Vector3<Scalar> r = residual[j].df();
      sum = multiply_add<Scalar>(G, r, sum);
    }
    return sum;
  }
  PHYSGEN_FUNCTION void put(SingleObject auto i, const Vector3<Scalar>& sum) const { corrections[i].dx() = sum; }
  PHYSGEN_FUNCTION void operator()(SingleObject auto i) const { put(i, part(i, Lane{})); }
};

}  // namespace physgen::fem
