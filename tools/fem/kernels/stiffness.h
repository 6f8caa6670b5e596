// Kernels: stiffness blocks of each tet, and their sums: a symmetric 3x3 per node and a full 3x3 per edge, which is
// half of what full block rows store.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/numerics/scalar.h>
#include <physgen/rows.h>

namespace physgen::fem {

namespace detail {

/// The 12 scalars of elasticity::StressDerivative as tables: normal(i, k) = x_iikk, shear(i, k) = x_ikik and
/// exchange(i, k) = x_ikki for i != k.
template <class S>
struct DerivativeTables {
  Matrix3<S> normal, shear, exchange;

  template <class Derivative>
  PHYSGEN_FUNCTION explicit DerivativeTables(const Derivative& x) {
    normal(0, 0) = x.x1111(), normal(1, 1) = x.x2222(), normal(2, 2) = x.x3333();
    normal(1, 0) = x.x2211(), normal(2, 0) = x.x3311(), normal(2, 1) = x.x3322();
    shear(1, 0) = x.x2121(), shear(2, 0) = x.x3131(), shear(2, 1) = x.x3232();
    exchange(1, 0) = x.x2112(), exchange(2, 0) = x.x3113(), exchange(2, 1) = x.x3223();
    PHYSGEN_UNROLL
    for (int c = 0; c < 3; ++c) {
      shear(c, c) = normal(c, c);  // so that the diagonal of a block is one sum
      PHYSGEN_UNROLL
      for (int r = c + 1; r < 3; ++r) {
        normal(c, r) = normal(r, c);
        shear(c, r) = shear(r, c);
        exchange(c, r) = exchange(r, c);
      }
    }
  }

  /// Block of corners with principal shape gradients a and b: K^_ik = sum_pq C^_ipkq a_p b_q.
  PHYSGEN_FUNCTION Matrix3<S> block(const Vector3<S>& a, const Vector3<S>& b) const {
    Matrix3<S> K;
    PHYSGEN_UNROLL
    for (int i = 0; i < 3; ++i) {
      PHYSGEN_UNROLL
      for (int k = 0; k < 3; ++k) {
        if (i == k) {
          K(i, i) = fma(shear(i, 0), a[0] * b[0], fma(shear(i, 1), a[1] * b[1], shear(i, 2) * (a[2] * b[2])));
        } else {
          K(i, k) = fma(normal(i, k), a[i] * b[k], exchange(i, k) * (a[k] * b[i]));
        }
      }
    }
    return K;
  }
};

}  // namespace detail

/// Blocks of one tet, df(a)/dx(b) = -volume U K^(V^T grad a, V^T grad b) U^T, with grad the gradients of the corners'
/// shape functions: the rows of Dm^-1, and minus their sum for corner i. [N/m]
template <class RestView, class SvdView, class DerivativeView, class TetStiffnessView>
struct ComputeTetStiffness {
  using Scalar = typename TetStiffnessView::Precision;
  RestView rest;               ///< elasticity::RestShape
  SvdView decomposition;       ///< elasticity::DeformationSvd, of which U and V are read
  DerivativeView derivative;   ///< elasticity::StressDerivative
  TetStiffnessView stiffness;  ///< elasticity::TetStiffness, written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const auto shape = rest[i];
    const Matrix3<S> dm_inverse = shape.dm_inverse(), U = decomposition[i].U(), V = decomposition[i].V();
    const S scale = -S(shape.volume());
    const detail::DerivativeTables<S> tables(derivative[i]);
    const Matrix3<S> rotated = multiply<S>(dm_inverse, V);  // row a: V^T grad of corner a + 1
    Vector3<S> g[4];
    g[1] = rotated.row(0).transpose();
    g[2] = rotated.row(1).transpose();
    g[3] = rotated.row(2).transpose();
    g[0] = -(g[1] + g[2] + g[3]);
    const auto block = [&](const Vector3<S>& a, const Vector3<S>& b) {
      return multiply_transpose<S>(multiply<S>(U, tables.block(a * scale, b)), U);
    };
    const auto out = stiffness[i];
    PHYSGEN_UNROLL
    for (int c = 0; c < 4; ++c) out.k(c) = block(g[c], g[c]);
    out.e(0) = block(g[0], g[1]);
    out.e(1) = block(g[0], g[2]);
    out.e(2) = block(g[0], g[3]);
    out.e(3) = block(g[1], g[2]);
    out.e(4) = block(g[1], g[3]);
    out.e(5) = block(g[2], g[3]);
  }
};

/// K(node) = sum of its corners' blocks over its tets.
template <class NodeTets, class TetStiffnessView, class NodeStiffnessView>
struct GatherNodeStiffness {
  using Scalar = typename NodeStiffnessView::Precision;
  NodeTets node_tets;          ///< Rows of elasticity::Incidence: tet, corner
  TetStiffnessView stiffness;  ///< elasticity::TetStiffness
  NodeStiffnessView nodes;     ///< elasticity::NodeStiffness, written

  /// @throw Error when there is not a row for each node, or rows do not name these tets
  GatherNodeStiffness(const NodeTets& rows, const TetStiffnessView& tets, const NodeStiffnessView& sums)
      : node_tets(rows), stiffness(tets), nodes(sums) {
    node_tets.require("GatherNodeStiffness: node_tets", nodes.size(), stiffness.size());
  }

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    nodes[node].K() = node_tets.sum(node, Matrix3<Scalar>::Zero(), [&](const auto& incidence) -> Matrix3<Scalar> {
      const int corner = incidence.local();
      return stiffness[index_t{incidence.element()}].k(corner);
    });
  }
};

/// E(m, n) = df(m)/dx(n): sum over the tets of the edge; local edges from 6 on run from n to m and are transposed.
template <class EdgeTets, class TetStiffnessView, class EdgeStiffnessView>
struct GatherEdgeStiffness {
  using Scalar = typename EdgeStiffnessView::Precision;
  EdgeTets edge_tets;          ///< Rows of elasticity::Incidence: tet, local edge + 6 if flipped
  TetStiffnessView stiffness;  ///< elasticity::TetStiffness
  EdgeStiffnessView edges;     ///< elasticity::EdgeStiffness, written

  /// @throw Error when there is not a row for each edge, or rows do not name these tets
  GatherEdgeStiffness(const EdgeTets& rows, const TetStiffnessView& tets, const EdgeStiffnessView& sums)
      : edge_tets(rows), stiffness(tets), edges(sums) {
    edge_tets.require("GatherEdgeStiffness: edge_tets", edges.size(), stiffness.size());
  }

  PHYSGEN_FUNCTION void operator()(SingleObject auto edge) const {
    edges[edge].E() = edge_tets.sum(edge, Matrix3<Scalar>::Zero(), [&](const auto& incidence) -> Matrix3<Scalar> {
      const int local = incidence.local();
      const auto tet = stiffness[index_t{incidence.element()}];
      if (local < 6) return tet.e(local);
      return tet.e(local - 6).get().transpose();
    });
  }
};

}  // namespace physgen::fem

#pragma pop_macro("I")
