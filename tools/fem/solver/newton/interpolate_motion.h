// For nested iteration: the motion that a coarser mesh has found, on the next finer one.
#pragma once

#include <fem/kernels/tet.h>
#include <fem/solver/arrays/packed_rows.h>
#include <fem/solver/free_part.h>
#include <physgen/kernel.h>

namespace physgen::fem {

/// Moves free components of nodes by how far the coarser mesh has moved where they were: x += w. A node between two
/// parents takes the cubic that has their motions and, along the edge between them, their gradients of the motion:
/// half-way w = (w_a + w_b)/2 + (G_a L - G_b L)/8. Where it lies beside that edge, as in cells of different widths, it
/// follows the gradients from there on. A parent's gradient is the mean over its tets, by volume. The straight line
/// between the motions would bend what was smooth at each coarse node, and Newton's method would begin with that.
template <class ParentsView, class FineRestView, class NodeTets, class TetView, class RestView, class BeforeView,
          class NowView, class ConstraintView, class PositionView>
struct InterpolateMotion {
  using Scalar = typename PositionView::Precision;
  bool bends;                  ///< else w = (w_a + w_b)/2: cubics may invert tets, and straight lines do not
  ParentsView parents;         ///< quasistatic::NodeParents
  FineRestView fine_rest;      ///< elasticity::NodePosition
  NodeTets node_tets;          ///< Rows of NodeTetEntry, of the coarser level
  TetView tets;                ///< elasticity::Tet, of the coarser level
  RestView rest;               ///< elasticity::NodePosition, of the coarser level
  BeforeView before;           ///< elasticity::NodePosition, of the coarser level
  NowView now;                 ///< elasticity::NodePosition, of the coarser level
  ConstraintView constraints;  ///< quasistatic::NodeConstraint
  PositionView positions;      ///< elasticity::NodePosition

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Vector = Vector3<Scalar>;
    const auto names = parents[node].nodes();
    const index_t a = names[0], b = names[1];
    const Vector first = motion(a), second = motion(b);
    Vector w = (first + second) * Scalar(0.5);
    if (bends && a != b) {
      const Vector from = rest[a].x(), edge = Vector(rest[b].x().get()) - from;
      const Vector at = Vector(fine_rest[node].x().get()) - from, off = at - edge * Scalar(0.5);
      const Scalar square = dot3<Scalar>(edge, edge), rounding(1e-9);
      if (dot3<Scalar>(off, off) <= rounding * rounding * square) {
        w += (slope(a, edge) - slope(b, edge)) * Scalar(0.125);
      } else {
        const Scalar s = dot3<Scalar>(at, edge) / square, t = Scalar(1) - s;
        const Vector beside = at - edge * s;
        w = first * ((Scalar(1) + Scalar(2) * s) * t * t) + second * ((Scalar(1) + Scalar(2) * t) * s * s) +
            slope(a, edge * (s * t * t) + beside * t) + slope(b, beside * s - edge * (s * s * t));
      }
    }
    positions[node].x() += detail::free_part<Scalar>(w, constraints[node]);
  }

 private:
  PHYSGEN_FUNCTION Vector3<Scalar> motion(index_t node) const {
    return Vector3<Scalar>(now[node].x().get()) - Vector3<Scalar>(before[node].x().get());
  }
  /// G L of a coarse node, G being the mean gradient of its tets' motions and L a distance at rest.
  PHYSGEN_FUNCTION Vector3<Scalar> slope(index_t node, const Vector3<Scalar>& edge) const {
    using Vector = Vector3<Scalar>;
    Vector sum = Vector::Zero();
    Scalar volume = 0;
    node_tets.for_each(node, [&](const auto& entry, bool /*active*/) {
      const index_t t = NodeTetEntry::element(entry);
      const auto dm = detail::edge_matrix<Scalar>(
          tets, t, [&](std::int32_t corner) -> Vector { return rest[index_t{corner}].x(); });
      const auto dw =
          detail::edge_matrix<Scalar>(tets, t, [&](std::int32_t corner) -> Vector { return motion(index_t{corner}); });
      const Vector p = dm.col(0), q = dm.col(1), r = dm.col(2), qr = cross3<Scalar>(q, r);
      const Vector shares(dot3<Scalar>(qr, edge), dot3<Scalar>(cross3<Scalar>(r, p), edge),
                          dot3<Scalar>(cross3<Scalar>(p, q), edge));
      sum = multiply_add<Scalar>(dw, shares, sum);
      volume += dot3<Scalar>(p, qr);
    });
    return sum / volume;
  }
};

}  // namespace physgen::fem
