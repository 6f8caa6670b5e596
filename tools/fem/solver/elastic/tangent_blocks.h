// Kernels: from the tets' tangents to the stiffness of edges and nodes, without blocks of tets in memory. Sums are
// gathers in a fixed order. It includes prescribed components, which vectors and the preconditioner leave out.
#pragma once

#include <fem/kernels/stiffness.h>
#include <fem/solver/arrays/packed_rows.h>
#include <fem/solver/elastic/tet_chunks.h>

namespace physgen::fem {

/// No rank-one parts of patches.
struct NoEdgePatches {
  static constexpr bool averages = false;
};

/// The patches that an edge's two nodes have in common.
template <class EdgePatches, class PatchTangentView>
struct EdgePatchTangents {
  static constexpr bool averages = true;
  EdgePatches edge_patches;  ///< Rows of EdgePatchEntry
  PatchTangentView tangent;  ///< quasistatic::PatchTangent
};

/// E(m, n) = df(m)/dx(n), as the sum over the edge's patches of -k g_m g_n^T, and over its tets of -volume U K^(g_m,
/// g_n) U^T, in this order: the bits do not depend on how many chunks of tets there are.
template <class EdgeTets, class Patches, class TetTangentView, class EdgeStiffnessView>
struct SumEdgeStiffness {
  using Scalar = typename EdgeStiffnessView::Precision;
  TetChunk chunk;           ///< whose tets are added; before the first, the patches. Called with 0 .. chunk.edges() - 1
  EdgeTets edge_tets;       ///< Rows of EdgeTetEntry
  Patches patches;          ///< NoEdgePatches or EdgePatchTangents
  TetTangentView tangent;   ///< quasistatic::TetTangent of the chunk
  EdgeStiffnessView edges;  ///< elasticity::EdgeStiffness: begun with the first chunk

  PHYSGEN_FUNCTION void operator()(SingleObject auto i) const {
    using Matrix = Matrix3<Scalar>;
    const auto edge = object_of_part(chunk.first_edge, i);
    Matrix before = Matrix::Zero();
    if (chunk.is_first()) {
      before = sum_of_patches(edge);
    } else {
      before = edges[edge].E();
    }
    const Matrix sum = edge_tets.fold(edge, before, [&](const Matrix& total, const auto& entry) -> Matrix {
      const index_t t = EdgeTetEntry::element(entry);
      if (!chunk.has(t)) return total;
      const int local = EdgeTetEntry::local(entry), forward = local < 6 ? local : local - 6;
      // (0,1) (0,2) (0,3) (1,2) (1,3) (2,3)
      const int first = forward < 3 ? 0 : (forward < 5 ? 1 : 2);
      const int second = forward < 3 ? forward + 1 : (forward == 3 ? 2 : 3);
      const auto tet = tangent[t - chunk.first_tet];
      const Matrix U = tet.U(), g = tet.g();
      const detail::DerivativeTables<Scalar> tables(tet);
      const Vector3<Scalar> a = gradient(g, local < 6 ? first : second), b = gradient(g, local < 6 ? second : first);
      return total + multiply_transpose<Scalar>(multiply<Scalar>(U, tables.block(-a, b)), U);
    });
    edges[edge].E() = sum;
  }

 private:
  PHYSGEN_FUNCTION Matrix3<Scalar> sum_of_patches(SingleObject auto edge) const {
    using Matrix = Matrix3<Scalar>;
    Matrix sum = Matrix::Zero();
    if constexpr (Patches::averages) {
      sum = patches.edge_patches.sum(edge, sum, [&](const auto& entry) -> Matrix {
        const int slots = EdgePatchEntry::local(entry);
        const auto patch = patches.tangent[EdgePatchEntry::element(entry)];
        const Scalar k = -Scalar(patch.k());
        const auto g = patch.g();
        const int m = 3 * (slots & 7), n = 3 * (slots >> 3);
        Matrix block;
        for (int c = 0; c < 3; ++c) {
          for (int r = 0; r < 3; ++r) block(r, c) = k * Scalar(g[m + r]) * Scalar(g[n + c]);
        }
        return block;
      });
    }
    return sum;
  }
  PHYSGEN_FUNCTION static Vector3<Scalar> gradient(const Matrix3<Scalar>& g, int corner) {
    if (corner == 0) return -(g.col(0) + g.col(1) + g.col(2));
    return corner == 1 ? g.col(0) : (corner == 2 ? g.col(1) : g.col(2));
  }
};

/// K(node) = -(sum of the blocks of its edges): a translation gives no force.
template <class NodeEdges, class EdgeStiffnessView, class NodeStiffnessView>
struct SumNodeStiffness {
  using Scalar = typename NodeStiffnessView::Precision;
  NodeEdges node_edges;     ///< Rows of NodeEdgeEntry
  EdgeStiffnessView edges;  ///< elasticity::EdgeStiffness
  NodeStiffnessView nodes;  ///< elasticity::NodeStiffness, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Matrix = Matrix3<Scalar>;
    const Matrix sum = node_edges.sum(node, Matrix(Matrix::Zero()), [&](const auto& entry) -> Matrix {
      const int side = NodeEdgeEntry::local(entry);
      const Matrix E = edges[NodeEdgeEntry::element(entry)].E();
      if (side == 0) return E;
      return E.transpose();
    });
    nodes[node].K() = Matrix((sum + sum.transpose()) * Scalar(-0.5));
  }
};

}  // namespace physgen::fem
