// Kernels between a level and the next coarser one, in the scaled unknowns of both: restriction of residuals and
// interpolation of corrections.
#pragma once

#include <fem/solver/free_part.h>
#include <fem/solver/preconditioners/multigrid/interpolation.h>
#include <fem/solver/preconditioners/multigrid/smoother.h>
#include <fem/solver/row_sums.h>
#include <physgen/kernel.h>
#include <physgen/rows.h>

namespace physgen::fem {

/// r of a coarse node = sum of weight times r of its children.
template <class Interpolation, class Children, class FineScaleView, class FineView, class ConstraintView,
          class ScaleView, class CoarseView>
struct RestrictResidual {
  using Scalar = typename CoarseView::Precision;
  Interpolation interpolation;  ///< HalfWay or InGrid
  Children children;            ///< Rows of ChildEntry
  FineScaleView fine_scales;    ///< quasistatic::NodeScale
  FineView fine;                ///< elasticity::NodeForceDifferential
  ConstraintView constraints;   ///< quasistatic::NodeConstraint, coarse
  ScaleView scales;             ///< quasistatic::NodeScale, coarse
  CoarseView coarse;            ///< elasticity::NodeForceDifferential, written

  static constexpr int lanes = 8;  ///< see run_rows()
  using Vector = Vector3<Scalar>;

  PHYSGEN_FUNCTION Vector part(SingleObject auto node, Lane lane) const {
    return sum_of_lane(children, node, lane, Vector(Vector::Zero()), [&](const auto& entry) -> Vector {
      const index_t child = ChildEntry::element(entry);
      const Vector r = fine[child].df();
      return r * (Scalar(fine_scales[child].inverse()) * interpolation.template weight<Scalar>(entry));
    });
  }
  PHYSGEN_FUNCTION void put(SingleObject auto node, const Vector& sum) const {
    const Vector scaled = sum * Scalar(scales[node].scale());
    coarse[node].df() = detail::free_part<Scalar>(scaled, constraints[node]);
  }
  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const { put(node, part(node, Lane{})); }
};

/// d = the parents' corrections, interpolated, z += d, and r takes in the nodes' part of K d.
template <class Interpolation, class CoarseScaleView, class CoarseView, class ConstraintView, class ScaleView,
          class NodeStiffnessView, class DirectionView, class CorrectionView, class ResidualView>
struct InterpolateCorrection {
  using Scalar = typename CorrectionView::Precision;
  Interpolation interpolation;    ///< HalfWay or InGrid
  CoarseScaleView coarse_scales;  ///< quasistatic::NodeScale
  CoarseView coarse;              ///< elasticity::NodeDisplacement
  ConstraintView constraints;     ///< quasistatic::NodeConstraint, fine
  ScaleView scales;               ///< quasistatic::NodeScale, fine
  NodeStiffnessView stiffness;    ///< elasticity::NodeStiffness, fine, scaled
  DirectionView direction;        ///< elasticity::NodeDisplacement: d, written
  CorrectionView corrections;     ///< elasticity::NodeDisplacement: z
  ResidualView residual;          ///< elasticity::NodeForceDifferential: r

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Vector = Vector3<Scalar>;
    const Vector interpolated = interpolation.template value<Scalar>(node, [&](index_t parent) -> Vector {
      const Vector z = coarse[parent].dx();
      return z * Scalar(coarse_scales[parent].scale());
    });
    const Vector scaled = interpolated * Scalar(scales[node].inverse());
    const Vector d = detail::free_part<Scalar>(scaled, constraints[node]);
    direction[node].dx() = d;
    corrections[node].dx() += d;
    add_node_product<Scalar>(stiffness, residual, node, d);
  }
};

}  // namespace physgen::fem
