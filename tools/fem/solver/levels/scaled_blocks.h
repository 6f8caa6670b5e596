// Kernels: the stiffness of a level as its preconditioner stores it: scaled to a unit diagonal, so that blocks of edges
// may be stored in half, and without prescribed components; and the inverses of the nodes' blocks. K is df/dx, negative
// semidefinite.
#pragma once

#include <fem/solver/arrays/packed_rows.h>
#include <fem/solver/free_part.h>
#include <physgen/kernel.h>
#include <physgen/rows.h>

#include <cmath>
#include <limits>

namespace physgen::fem {

/// The scale of each node.
template <class NodeStiffnessView, class ScaleView>
struct ComputeNodeScale {
  using Scalar = typename ScaleView::Precision;
  bool unit;                    ///< all scales are 1
  NodeStiffnessView stiffness;  ///< elasticity::NodeStiffness
  ScaleView scales;             ///< quasistatic::NodeScale, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    const Matrix3<Scalar> K = stiffness[node].K();
    const Scalar largest = math::max(math::max(math::abs(K(0, 0)), math::abs(K(1, 1))), math::abs(K(2, 2)));
    Scalar scale(1), inverse(1);
    // Steps of 2 in scale are steps of 4 in scale^2 K: into [1/2, 2). A node without stiffness keeps 1.
    if (!unit && largest > Scalar(0) && largest < std::numeric_limits<Scalar>::infinity()) {
      const int exponent = ilogb(largest);
      const int half = (exponent + (exponent > 0 ? 1 : 0)) / 2;
      scale = ldexp(Scalar(1), -half);
      inverse = ldexp(Scalar(1), half);
    }
    scales[node].scale() = scale;
    scales[node].inverse() = inverse;
  }

 private:
  PHYSGEN_FUNCTION static int ilogb(Scalar x) { return std::ilogb(x); }
  PHYSGEN_FUNCTION static Scalar ldexp(Scalar x, int exponent) { return std::ldexp(x, exponent); }
};

/// The scaled block of a node without prescribed components, and its inverse, times -1: by LDL^T, in which a component
/// whose pivot is not negative is left out.
template <class NodeStiffnessView, class ConstraintView, class ScaleView, class ScaledView, class InverseView>
struct ScaleNodes {
  using Scalar = typename ScaleView::Precision;
  NodeStiffnessView stiffness;  ///< elasticity::NodeStiffness
  ConstraintView constraints;   ///< quasistatic::NodeConstraint
  ScaleView scales;             ///< quasistatic::NodeScale
  ScaledView scaled;            ///< elasticity::NodeStiffness, written
  InverseView inverse;          ///< quasistatic::NodeInverse, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Matrix = Matrix3<Scalar>;
    const Scalar s = scales[node].scale();
    Matrix K = Matrix(stiffness[node].K().get()) * (s * s);
    const int fixed = constraints[node].fixed();
    if (fixed != 0) K = detail::free_block<Scalar>(K, fixed, fixed);
    scaled[node].K() = K;
    // -K = L diag(d) L^T, and its inverse from e = 1/d; e = 0 takes a component out.
    const auto none = Scalar(0), small = Scalar(1e-6);
    const auto pivot = [&](Scalar d) { return d > small ? Scalar(1) / d : none; };
    const Scalar e0 = pivot(-K(0, 0));
    const Scalar l10 = -K(1, 0) * e0, l20 = -K(2, 0) * e0;
    const Scalar e1 = pivot(-K(1, 1) + l10 * K(1, 0));
    const Scalar l21 = (-K(2, 1) + l20 * K(1, 0)) * e1;
    const Scalar d2 = -K(2, 2) + l20 * K(2, 0) - (e1 > none ? l21 * l21 / e1 : none);
    const Scalar e2 = pivot(d2);
    // D = L^-T diag(e) L^-1, L^-1 = [1; -l10 1; m20 -l21 1]
    const Scalar m20 = l10 * l21 - l20;
    Matrix D;
    D(2, 2) = e2;
    D(2, 1) = D(1, 2) = -l21 * e2;
    D(2, 0) = D(0, 2) = m20 * e2;
    D(1, 1) = e1 + l21 * l21 * e2;
    D(1, 0) = D(0, 1) = -l10 * e1 - l21 * m20 * e2;
    D(0, 0) = e0 + l10 * l10 * e1 + m20 * m20 * e2;
    inverse[node].D() = D;
  }
};

/// The scaled blocks of edges without prescribed components.
template <class EdgeView, class ConstraintView, class EdgeStiffnessView, class ScaleView, class ScaledView>
struct ScaleEdges {
  using Scalar = typename ScaleView::Precision;
  EdgeView edges;               ///< elasticity::Edge
  ConstraintView constraints;   ///< quasistatic::NodeConstraint
  EdgeStiffnessView stiffness;  ///< elasticity::EdgeStiffness
  ScaleView scales;             ///< quasistatic::NodeScale
  ScaledView scaled;            ///< elasticity::EdgeStiffness, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto edge) const { (*this)(edge, edge, 0); }
  /// @param block the number of the scaled one
  /// @param side from which it is seen: 0, df(m)/dx(n); 1, df(n)/dx(m)
  PHYSGEN_FUNCTION void operator()(SingleObject auto edge, SingleObject auto block, int side) const {
    const auto ends = edges[edge].nodes();
    const index_t m = ends[0], n = ends[1];
    const Scalar factor = Scalar(scales[m].scale()) * Scalar(scales[n].scale());
    const int of_m = constraints[m].fixed(), of_n = constraints[n].fixed();
    Matrix3<Scalar> E = stiffness[edge].E();
    E *= factor;
    if ((of_m | of_n) != 0) E = detail::free_block<Scalar>(E, of_m, of_n);
    if (side != 0) E = Matrix3<Scalar>(E.transpose());
    scaled[block].E() = E;
  }
};

/// Adds to a node's block what its edges' blocks have lost by storage, as a translation feels it: so a translation
/// still gives no force, and stiffness that is rounded stays soft where it was soft.
/// @tparam Format of the stored blocks
template <class Format, class NodeEdges, class EdgeView, class ConstraintView, class ScaleView, class EdgeStiffnessView,
          class ScaledNodesView>
struct KeepTranslations {
  using Scalar = typename ScaledNodesView::Precision;
  NodeEdges node_edges;          ///< Rows of NodeEdgeEntry
  EdgeView edges;                ///< elasticity::Edge
  ConstraintView constraints;    ///< quasistatic::NodeConstraint
  ScaleView scales;              ///< quasistatic::NodeScale
  EdgeStiffnessView stiffness;   ///< elasticity::EdgeStiffness
  ScaledNodesView scaled_nodes;  ///< elasticity::NodeStiffness

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Matrix = Matrix3<Scalar>;
    const int fixed = constraints[node].fixed();
    const Scalar scale = scales[node].scale();
    const Matrix lost = node_edges.sum(node, Matrix(Matrix::Zero()), [&](const auto& entry) -> Matrix {
      const index_t edge = NodeEdgeEntry::element(entry);
      const int side = NodeEdgeEntry::local(entry);
      const index_t other = edges[edge].nodes()[1 - side];
      Matrix E = stiffness[edge].E();
      E *= scale * Scalar(scales[other].scale());
      const int of_other = constraints[other].fixed();
      if ((fixed | of_other) != 0)
        E = detail::free_block<Scalar>(E, side == 0 ? fixed : of_other, side == 0 ? of_other : fixed);
      for (int k = 0; k < 9; ++k) {
        Scalar& x = E.data()[k];
        x -= Format::template decode<Scalar>(Format::template encode<Scalar>(x));
      }
      E *= scale * Scalar(scales[other].inverse());
      if (side == 0) return E;
      return E.transpose();
    });
    const Matrix K = scaled_nodes[node].K();
    const Matrix corrected = K + (lost + lost.transpose()) * Scalar(0.5);
    scaled_nodes[node].K() = Matrix(detail::free_block<Scalar>(corrected, fixed, fixed));
  }
};

/// @tparam Format of the stored blocks
template <class Format, class... Views>
[[nodiscard]] KeepTranslations<Format, Views...> keep_translations(const Views&... views) {
  return {views...};
}

/// The scales of a level's nodes, their scaled blocks and the inverses of these. @param unit whether all scales are 1
template <class On, class Level>
void scale_nodes(On& on, Level& level, bool unit) {
  const index_t n = level.nodes();
  const auto scales = level.scales.view();
  const auto inverse = level.inverse.view();
  on.run(n, ComputeNodeScale{unit, level.node_stiffness.const_view(), scales});
  on.run(n, ScaleNodes{level.node_stiffness.const_view(), level.constraints.const_view(), level.scales.const_view(),
                       level.scaled_nodes.view(), inverse});
}

}  // namespace physgen::fem
