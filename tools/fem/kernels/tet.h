// Shapes of a linear tet from its gathered corners, for all kernels that read nodes.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/numerics/scalar.h>
#include <physgen/kernels/pack.h>

namespace physgen::fem::detail {

/// [y_j - y_i, y_k - y_i, y_l - y_i] by columns, y(node) being a vector of each of the tet's (or the pack's tets')
/// nodes.
template <class Scalar, class I, class TetView, class NodeVector>
PHYSGEN_FUNCTION inline Matrix3<lanes_t<Scalar, I>> edge_matrix(const TetView& tets, I i, const NodeVector& y) {
  using S = lanes_t<Scalar, I>;
  using Node = lanes_t<std::int32_t, I>;
  const auto nodes = tets[i].nodes();
  const Node first = nodes[0], second = nodes[1], third = nodes[2], fourth = nodes[3];
  const Vector3<S> origin = y(first);
  Matrix3<S> edges;
  edges.col(0) = y(second) - origin;
  edges.col(1) = y(third) - origin;
  edges.col(2) = y(fourth) - origin;
  return edges;
}

}  // namespace physgen::fem::detail

#pragma pop_macro("I")
