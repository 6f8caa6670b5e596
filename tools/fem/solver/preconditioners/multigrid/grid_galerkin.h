// Kernels: the stiffness of background grids, P^T M K M P. P is linear interpolation in the grid's tets; M takes out
// what is prescribed, so that a grid may interpolate across prescribed nodes: with a grid that is held wherever a
// prescribed node is near, a body that is held inside of the box takes twice to three times the iterations.
//
// Which fine blocks each coarse block consists of is listed once per topology (hierarchy.h); their weights are looked
// up, since a fine edge has up to sixteen. M K M resists translations where something is prescribed: by T = P^T M K M
// 1, which coarsens as a vector does, and is what the blocks of nodes have beside the sum of those of their edges.
#pragma once

#include <fem/solver/arrays/packed_rows.h>
#include <fem/solver/free_part.h>
#include <fem/solver/hierarchy/galerkin_block.h>
#include <physgen/kernel.h>
#include <physgen/rows.h>

namespace physgen::fem {

namespace detail {

/// The weight of a coarse node among a node's parents.
template <class Scalar, class Parents>
PHYSGEN_FUNCTION inline Scalar weight_of(const Parents& parents, index_t coarse) {
  const auto names = parents.nodes();
  const auto weights = parents.weights();
  Scalar sum(0);
  for (int k = 0; k < 4; ++k) {
    if (index_t{names[k]} == coarse) sum += Scalar(weights[k]);
  }
  return sum;
}

}  // namespace detail

/// Blocks of coarse edges (A, B): w_aA w_aB K of fine nodes a, and w_aA w_bB E + w_bA w_aB E^T of fine edges (a, b).
template <class Terms, class ParentsView, class ConstraintView, class FineEdgeView, class NodeStiffnessView,
          class EdgeStiffnessView, class CoarseEdgeView, class CoarseView>
struct CoarsenToGrid {
  using Scalar = typename CoarseView::Precision;
  Terms terms;                  ///< Rows of EdgeTermEntry
  ParentsView parents;          ///< quasistatic::GridParents
  ConstraintView constraints;   ///< quasistatic::NodeConstraint, of the finer level
  FineEdgeView fine_edges;      ///< elasticity::Edge, of the finer level
  NodeStiffnessView nodes;      ///< elasticity::NodeStiffness, of the finer level
  EdgeStiffnessView edges;      ///< elasticity::EdgeStiffness, of the finer level
  CoarseEdgeView coarse_edges;  ///< elasticity::Edge
  CoarseView coarse;            ///< elasticity::EdgeStiffness, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto edge) const {
    using Matrix = Matrix3<Scalar>;
    const auto ends = coarse_edges[edge].nodes();
    const index_t A = ends[0], B = ends[1];
    coarse[edge].E() = terms.sum(edge, Matrix(Matrix::Zero()), [&](const auto& entry) -> Matrix {
      const index_t element = EdgeTermEntry::element(entry);
      const int code = EdgeTermEntry::local(entry);
      if (fem::galerkin_block(code) == GalerkinBlock::node) {
        const int fixed = constraints[element].fixed();
        Matrix K = nodes[element].K();
        if (fixed != 0) K = detail::free_block<Scalar>(K, fixed, fixed);
        return K * (detail::weight_of<Scalar>(parents[element], A) * detail::weight_of<Scalar>(parents[element], B));
      }
      const auto names = fine_edges[element].nodes();
      const index_t a = names[0], b = names[1];
      const int of_a = constraints[a].fixed(), of_b = constraints[b].fixed();
      Matrix E = edges[element].E();
      if ((of_a | of_b) != 0) E = detail::free_block<Scalar>(E, of_a, of_b);
      const Scalar direct = detail::weight_of<Scalar>(parents[a], A) * detail::weight_of<Scalar>(parents[b], B);
      const Scalar reverse = detail::weight_of<Scalar>(parents[b], A) * detail::weight_of<Scalar>(parents[a], B);
      return E * direct + E.transpose() * reverse;
    });
  }
};

/// T of a node of the mesh on a grid: its row of M K M, summed.
template <class NodeEdges, class EdgeView, class ConstraintView, class NodeStiffnessView, class EdgeStiffnessView,
          class TranslationView>
struct SumTranslationStiffness {
  using Scalar = typename TranslationView::Precision;
  NodeEdges node_edges;          ///< Rows of NodeEdgeEntry
  EdgeView ends;                 ///< elasticity::Edge
  ConstraintView constraints;    ///< quasistatic::NodeConstraint
  NodeStiffnessView nodes;       ///< elasticity::NodeStiffness
  EdgeStiffnessView edges;       ///< elasticity::EdgeStiffness
  TranslationView translations;  ///< quasistatic::TranslationStiffness, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Matrix = Matrix3<Scalar>;
    // All of a row adds up to 0: T is minus what M takes out.
    const int fixed = constraints[node].fixed();
    Matrix taken = Matrix::Zero();
    if (fixed != 7) {
      const Matrix K = nodes[node].K();
      taken =
          node_edges.sum(node, Matrix(K - detail::free_block<Scalar>(K, 0, fixed)), [&](const auto& entry) -> Matrix {
            const index_t edge = NodeEdgeEntry::element(entry);
            const int side = NodeEdgeEntry::local(entry);
            const index_t other = ends[edge].nodes()[1 - side];
            const int of_other = constraints[other].fixed();
            if (of_other == 0) return Matrix::Zero();
            const Matrix E = edges[edge].E();
            const Matrix own = side == 0 ? E : Matrix(E.transpose());
            return own - detail::free_block<Scalar>(own, 0, of_other);
          });
    }
    translations[node].T() = Matrix(detail::free_block<Scalar>(-taken, fixed, 0));
  }
};

/// T takes in what rigid planes add to the nodes' blocks.
template <class ConstraintView, class PlaneView, class TranslationView>
struct AddPlaneTranslations {
  using Scalar = typename TranslationView::Precision;
  ConstraintView constraints;    ///< quasistatic::NodeConstraint
  PlaneView planes;              ///< elasticity::NodeStiffness: the part that planes have
  TranslationView translations;  ///< quasistatic::TranslationStiffness

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Matrix = Matrix3<Scalar>;
    const int fixed = constraints[node].fixed();
    const Matrix K = planes[node].K();
    const Matrix T = translations[node].T();
    translations[node].T() = Matrix(T + detail::free_block<Scalar>(K, fixed, fixed));
  }
};

/// T of a grid's node from that of its children.
template <class Interpolation, class Children, class FineView, class CoarseView>
struct CoarsenTranslationStiffness {
  using Scalar = typename CoarseView::Precision;
  Interpolation interpolation;  ///< HalfWay or InGrid
  Children children;            ///< Rows of ChildEntry
  FineView fine;                ///< quasistatic::TranslationStiffness
  CoarseView coarse;            ///< quasistatic::TranslationStiffness, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Matrix = Matrix3<Scalar>;
    coarse[node].T() = children.sum(node, Matrix(Matrix::Zero()), [&](const auto& entry) -> Matrix {
      const Matrix T = fine[ChildEntry::element(entry)].T();
      return T * interpolation.template weight<Scalar>(entry);
    });
  }
};

/// K of a grid's node = T - (sum of the blocks of its edges).
template <class TranslationView, class NodeStiffnessView>
struct AddTranslationStiffness {
  using Scalar = typename NodeStiffnessView::Precision;
  TranslationView translations;  ///< quasistatic::TranslationStiffness
  NodeStiffnessView nodes;       ///< elasticity::NodeStiffness: minus the sum, by SumNodeStiffness

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Matrix = Matrix3<Scalar>;
    const Matrix T = translations[node].T(), K = nodes[node].K();
    nodes[node].K() = Matrix(K + (T + T.transpose()) * Scalar(0.5));
  }
};

}  // namespace physgen::fem
