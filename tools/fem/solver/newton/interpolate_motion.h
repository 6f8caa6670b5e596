// For nested iteration: the motion that a coarser mesh has found, on the next finer one.
#pragma once

#include <fem/kernels/tet.h>
#include <fem/solver/arrays/packed_rows.h>
#include <fem/solver/free_part.h>
#include <physgen/kernel.h>

namespace physgen::fem {

namespace detail {

/// How far a node has moved. @param before, now views of elasticity::NodePosition
template <class Scalar, class BeforeView, class NowView>
PHYSGEN_FUNCTION inline Vector3<Scalar> motion(const BeforeView& before, const NowView& now, index_t node) {
  return Vector3<Scalar>(now[node].x().get()) - Vector3<Scalar>(before[node].x().get());
}

}  // namespace detail

/// Matrices of nodes, of which three arrays have the columns.
template <class FirstView, class SecondView, class ThirdView>
struct NodeMatrices {
  FirstView first;    ///< elasticity::NodePosition
  SecondView second;  ///< elasticity::NodeForce
  ThirdView third;    ///< elasticity::NodeDisplacement

  /// A v
  template <class Scalar>
  PHYSGEN_FUNCTION Vector3<Scalar> times(index_t node, const Vector3<Scalar>& v) const {
    Matrix3<Scalar> A;
    A.col(0) = Vector3<Scalar>(first[node].x().get());
    A.col(1) = Vector3<Scalar>(second[node].f().get());
    A.col(2) = Vector3<Scalar>(third[node].dx().get());
    return multiply_add<Scalar>(A, v, Vector3<Scalar>::Zero());
  }
};
/// In what Newton's method leaves behind on a mesh, and writes anew before it is read: nothing is stored beside it.
template <class Arrays>
[[nodiscard]] auto node_matrices(Arrays& a) {
  return NodeMatrices{a.trial.view(), a.trial_forces.view(), a.increment.view()};
}
template <class Arrays>
[[nodiscard]] auto const_node_matrices(const Arrays& a) {
  return NodeMatrices{a.trial.const_view(), a.trial_forces.const_view(), a.increment.const_view()};
}

/// The gradients of the motion at nodes: of each the mean over its tets, by volume.
template <class NodeTets, class TetView, class RestView, class BeforeView, class NowView, class Gradients>
struct AverageMotionGradients {
  using Scalar = typename NowView::Precision;
  NodeTets node_tets;   ///< Rows of NodeTetEntry
  TetView tets;         ///< elasticity::Tet
  RestView rest;        ///< elasticity::NodePosition
  BeforeView before;    ///< elasticity::NodePosition
  NowView now;          ///< elasticity::NodePosition
  Gradients gradients;  ///< NodeMatrices, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Vector = Vector3<Scalar>;
    Matrix3<Scalar> sum = Matrix3<Scalar>::Zero();
    Scalar volume = 0;
    node_tets.for_each(node, [&](const auto& entry, bool /*active*/) {
      const index_t t = NodeTetEntry::element(entry);
      const auto dm = detail::edge_matrix<Scalar>(
          tets, t, [&](std::int32_t corner) -> Vector { return rest[index_t{corner}].x(); });
      const auto dw = detail::edge_matrix<Scalar>(
          tets, t, [&](std::int32_t corner) -> Vector { return detail::motion<Scalar>(before, now, index_t{corner}); });
      const Vector p = dm.col(0), q = dm.col(1), r = dm.col(2);
      const Vector qr = cross3<Scalar>(q, r), rp = cross3<Scalar>(r, p), pq = cross3<Scalar>(p, q);
      for (int c = 0; c < 3; ++c) {
        sum.col(c) = multiply_add<Scalar>(dw, Vector(qr[c], rp[c], pq[c]), Vector(sum.col(c)));
      }
      volume += dot3<Scalar>(p, qr);
    });
    gradients.first[node].x() = Vector(sum.col(0) / volume);
    gradients.second[node].f() = Vector(sum.col(1) / volume);
    gradients.third[node].dx() = Vector(sum.col(2) / volume);
  }
};

/// Moves free components of nodes by how far the coarser mesh has moved where they were: x += w. A node between two
/// parents takes the cubic that has their motions and, along the edge between them, their gradients of the motion:
/// half-way w = (w_a + w_b)/2 + (G_a L - G_b L)/8. Where it lies beside that edge, as in cells of different widths, it
/// follows the gradients from there on. The straight line between the motions would bend what was smooth at each coarse
/// node, and Newton's method would begin with that.
template <class ParentsView, class FineRestView, class RestView, class BeforeView, class NowView, class Gradients,
          class ConstraintView, class PositionView>
struct InterpolateMotion {
  using Scalar = typename PositionView::Precision;
  bool bends;                  ///< else w = (w_a + w_b)/2: cubics may invert tets, and straight lines do not
  ParentsView parents;         ///< quasistatic::NodeParents
  FineRestView fine_rest;      ///< elasticity::NodePosition
  RestView rest;               ///< elasticity::NodePosition, of the coarser level
  BeforeView before;           ///< elasticity::NodePosition, of the coarser level
  NowView now;                 ///< elasticity::NodePosition, of the coarser level
  Gradients gradients;         ///< NodeMatrices, of the coarser level: read where it bends
  ConstraintView constraints;  ///< quasistatic::NodeConstraint
  PositionView positions;      ///< elasticity::NodePosition

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Vector = Vector3<Scalar>;
    const auto names = parents[node].nodes();
    const index_t a = names[0], b = names[1];
    const Vector first = detail::motion<Scalar>(before, now, a), second = detail::motion<Scalar>(before, now, b);
    Vector w = (first + second) * Scalar(0.5);
    if (bends && a != b) {
      const Vector from = rest[a].x(), edge = Vector(rest[b].x().get()) - from;
      const Vector at = Vector(fine_rest[node].x().get()) - from, off = at - edge * Scalar(0.5);
      const Scalar square = dot3<Scalar>(edge, edge), rounding(1e-9);
      if (dot3<Scalar>(off, off) <= rounding * rounding * square) {
        w += (gradients.template times<Scalar>(a, edge) - gradients.template times<Scalar>(b, edge)) * Scalar(0.125);
      } else {
        const Scalar s = dot3<Scalar>(at, edge) / square, t = Scalar(1) - s;
        const Vector beside = at - edge * s;
        w = first * ((Scalar(1) + Scalar(2) * s) * t * t) + second * ((Scalar(1) + Scalar(2) * t) * s * s) +
            gradients.template times<Scalar>(a, edge * (s * t * t) + beside * t) +
            gradients.template times<Scalar>(b, beside * s - edge * (s * s * t));
      }
    }
    positions[node].x() += detail::free_part<Scalar>(w, constraints[node]);
  }
};

}  // namespace physgen::fem
