// Kernels between a level and the next coarser one, in the scaled unknowns of both: restriction of residuals,
// interpolation of corrections, and interpolation of displacements for nested iteration.
#pragma once

#include <fem/solver/free_part.h>
#include <fem/solver/packed_rows.h>
#include <fem/solver/smoother.h>
#include <physgen/kernel.h>
#include <physgen/rows.h>

namespace physgen::fem {

/// r of a coarse node = sum of half of r of its children, twice where a child coincides with it.
template <class Children, class FineScaleView, class FineView, class ConstraintView, class ScaleView, class CoarseView>
struct RestrictResidual {
  using Scalar = typename CoarseView::Precision;
  Children children;           ///< Rows of ChildEntry
  FineScaleView fine_scales;   ///< quasistatic::NodeScale
  FineView fine;               ///< elasticity::NodeForceDifferential
  ConstraintView constraints;  ///< quasistatic::NodeConstraint, coarse
  ScaleView scales;            ///< quasistatic::NodeScale, coarse
  CoarseView coarse;           ///< elasticity::NodeForceDifferential, written

  PHYSGEN_FUNCTION void operator()(index_t node) const {
    using Vector = Vector3<Scalar>;
    const Vector sum = children.sum(node, Vector(Vector::Zero()), [&](const auto& entry) -> Vector {
      const index_t child = ChildEntry::element(entry);
      const int parents = ChildEntry::local(entry);
      const Vector r = fine[child].df();
      return r * (Scalar(fine_scales[child].inverse()) * Scalar(0.5) * Scalar(parents));
    });
    const Vector scaled = sum * Scalar(scales[node].scale());
    coarse[node].df() = detail::free_part<Scalar>(scaled, constraints[node]);
  }
};
template <class... Arguments>
RestrictResidual(Arguments...) -> RestrictResidual<Arguments...>;

/// d = the mean of the parents' corrections, z += d, and r takes in the nodes' part of K d.
template <class ParentsView, class CoarseScaleView, class CoarseView, class ConstraintView, class ScaleView,
          class NodeStiffnessView, class DirectionView, class CorrectionView, class ResidualView>
struct InterpolateCorrection {
  using Scalar = typename CorrectionView::Precision;
  ParentsView parents;            ///< quasistatic::NodeParents
  CoarseScaleView coarse_scales;  ///< quasistatic::NodeScale
  CoarseView coarse;              ///< elasticity::NodeDisplacement
  ConstraintView constraints;     ///< quasistatic::NodeConstraint, fine
  ScaleView scales;               ///< quasistatic::NodeScale, fine
  NodeStiffnessView stiffness;    ///< elasticity::NodeStiffness, fine, scaled
  DirectionView direction;        ///< elasticity::NodeDisplacement: d, written
  CorrectionView corrections;     ///< elasticity::NodeDisplacement: z
  ResidualView residual;          ///< elasticity::NodeForceDifferential: r

  PHYSGEN_FUNCTION void operator()(index_t node) const {
    using Vector = Vector3<Scalar>;
    const auto names = parents[node].nodes();
    const index_t first = names[0], second = names[1];
    const Vector a = coarse[first].dx(), b = coarse[second].dx();
    const Vector sum = a * Scalar(coarse_scales[first].scale()) + b * Scalar(coarse_scales[second].scale());
    const Vector scaled = sum * (Scalar(0.5) * Scalar(scales[node].inverse()));
    const Vector d = detail::free_part<Scalar>(scaled, constraints[node]);
    direction[node].dx() = d;
    corrections[node].dx() += d;
    add_node_product<Scalar>(stiffness, residual, node, d);
  }
};
template <class... Arguments>
InterpolateCorrection(Arguments...) -> InterpolateCorrection<Arguments...>;

/// Moves free components of nodes by the mean of how far their parents have moved: x += mean(now - before).
template <class ParentsView, class CoarseView, class ConstraintView, class PositionView>
struct InterpolateMotion {
  using Scalar = typename PositionView::Precision;
  ParentsView parents;         ///< quasistatic::NodeParents
  CoarseView before, now;      ///< elasticity::NodePosition, of the coarser level
  ConstraintView constraints;  ///< quasistatic::NodeConstraint
  PositionView positions;      ///< elasticity::NodePosition

  PHYSGEN_FUNCTION void operator()(index_t node) const {
    using Vector = Vector3<Scalar>;
    const auto names = parents[node].nodes();
    const index_t first = names[0], second = names[1];
    const Vector a = Vector(now[first].x().get()) - Vector(before[first].x().get());
    const Vector b = Vector(now[second].x().get()) - Vector(before[second].x().get());
    const Vector motion = (a + b) * Scalar(0.5);
    positions[node].x() += detail::free_part<Scalar>(motion, constraints[node]);
  }
};
template <class ParentsView, class CoarseView, class ConstraintView, class PositionView>
InterpolateMotion(ParentsView, CoarseView, CoarseView, ConstraintView, PositionView)
    -> InterpolateMotion<ParentsView, CoarseView, ConstraintView, PositionView>;

}  // namespace physgen::fem
