// The assembled stiffness as a sparse matrix of Eigen, for solvers, eigenvalues and files of other libraries:
//   const Eigen::SparseMatrix<double> K = fem::sparse_stiffness(nodes.const_view(), edges.const_view(),
//   ends.const_view()); Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(K);
#pragma once

#include <physgen/error.h>
#include <physgen/kernel.h>

#include <Eigen/SparseCore>
#include <limits>
#include <string>
#include <vector>

namespace physgen::fem {

/// df = K dx, with component k of node v in row and column 3 v + k. On the host, from arrays in any layout and format.
/// @param node_stiffness view of elasticity::NodeStiffness [N/m], one for each node
/// @param edge_stiffness view of elasticity::EdgeStiffness [N/m], one for each edge
/// @param edges view of elasticity::Edge, in any order; blocks of edges between the same two nodes are added
/// @return both triangles, 9 (nodes + 2 edges) entries, zeros among them: entries whose value is 0 are kept
/// @throw Error when edges and their blocks differ in number, an edge names a node that is not there, or the entries
/// are
///   too many for Int, the type of Eigen's indices
template <class Real = double, class Int = int, class NodeStiffnessView, class EdgeStiffnessView, class EdgeView>
[[nodiscard]] Eigen::SparseMatrix<Real, Eigen::ColMajor, Int> sparse_stiffness(const NodeStiffnessView& node_stiffness,
                                                                               const EdgeStiffnessView& edge_stiffness,
                                                                               const EdgeView& edges) {
  const index_t nodes = node_stiffness.size(), count = edges.size(), entries = 9 * (nodes + 2 * count);
  if (edge_stiffness.size() != count) {
    throw Error("sparse_stiffness: there are " + std::to_string(count) + " edges and " +
                std::to_string(edge_stiffness.size()) + " blocks of edges; give one block for each edge");
  }
  if (entries > index_t{std::numeric_limits<Int>::max()}) {
    throw Error("sparse_stiffness: " + std::to_string(entries) + " entries are more than its indices of " +
                std::to_string(8 * sizeof(Int)) + " bits allow; call sparse_stiffness<Real, std::int64_t>");
  }
  std::vector<Eigen::Triplet<Real, Int>> triplets;
  triplets.reserve(static_cast<std::size_t>(entries));
  const auto add = [&triplets](index_t row, index_t column, const auto& block) {
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) {
        triplets.emplace_back(static_cast<Int>(3 * row + r), static_cast<Int>(3 * column + c),
                              static_cast<Real>(block(r, c)));
      }
    }
  };
  for (index_t v = 0; v < nodes; ++v) {
    const Eigen::Matrix<typename NodeStiffnessView::Precision, 3, 3> K = node_stiffness[v].K();
    add(v, v, K);
  }
  for (index_t edge = 0; edge < count; ++edge) {
    const index_t m = edges[edge].nodes()[0], n = edges[edge].nodes()[1];
    if (m < 0 || n < 0 || m >= nodes || n >= nodes) {
      throw Error("sparse_stiffness: edge " + std::to_string(edge) + " is (" + std::to_string(m) + ", " +
                  std::to_string(n) + "), and there are " + std::to_string(nodes) + " nodes");
    }
    const Eigen::Matrix<typename EdgeStiffnessView::Precision, 3, 3> E = edge_stiffness[edge].E();
    add(m, n, E);
    add(n, m, E.transpose());
  }
  Eigen::SparseMatrix<Real, Eigen::ColMajor, Int> K(static_cast<Int>(3 * nodes), static_cast<Int>(3 * nodes));
  K.setFromTriplets(triplets.begin(), triplets.end());
  return K;
}

}  // namespace physgen::fem
