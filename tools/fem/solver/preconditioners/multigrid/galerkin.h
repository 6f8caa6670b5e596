// Kernels: the stiffness of the next coarser level, P^T K P, P being linear interpolation between the parents of each
// node. What each coarse block consists of is listed once per topology (hierarchy.h).
#pragma once

#include <fem/numerics/scalar.h>
#include <fem/solver/arrays/packed_rows.h>
#include <fem/solver/hierarchy/galerkin_block.h>
#include <physgen/kernel.h>
#include <physgen/rows.h>

namespace physgen::fem {

namespace detail {

template <class Scalar, class NodeStiffnessView, class EdgeStiffnessView, class Entry>
PHYSGEN_FUNCTION inline Matrix3<Scalar> fine_block(const NodeStiffnessView& nodes, const EdgeStiffnessView& edges,
                                                   const Entry& entry) {
  const int code = EdgeTermEntry::local(entry);
  const index_t element = EdgeTermEntry::element(entry);
  const Scalar weight = Scalar(0.25) * Scalar(galerkin_quarters(code));
  const GalerkinBlock kind = fem::galerkin_block(code);
  if (kind == GalerkinBlock::node) {
    const Matrix3<Scalar> K = nodes[element].K();
    return K * weight;
  }
  const Matrix3<Scalar> E = edges[element].E();
  if (kind == GalerkinBlock::edge) return E * weight;
  return E.transpose() * weight;
}

}  // namespace detail

/// Blocks of coarse edges. Those of coarse nodes follow from them, as on the finest level (SumNodeStiffness).
template <class Terms, class NodeStiffnessView, class EdgeStiffnessView, class CoarseView>
struct CoarsenEdgeStiffness {
  using Scalar = typename CoarseView::Precision;
  Terms terms;              ///< Rows of EdgeTermEntry: fine block, what of it
  NodeStiffnessView nodes;  ///< elasticity::NodeStiffness, of the finer level
  EdgeStiffnessView edges;  ///< elasticity::EdgeStiffness, of the finer level
  CoarseView coarse;        ///< elasticity::EdgeStiffness, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto edge) const {
    using Matrix = Matrix3<Scalar>;
    coarse[edge].E() = terms.sum(edge, Matrix(Matrix::Zero()), [&](const auto& entry) -> Matrix {
      return detail::fine_block<Scalar>(nodes, edges, entry);
    });
  }
};

}  // namespace physgen::fem
