// Sums at nodes of what a chunk of tets does at its corners.
#pragma once

#include <fem/numerics/scalar.h>
#include <fem/solver/arrays/packed_rows.h>
#include <fem/solver/elastic/tet_chunks.h>
#include <physgen/rows.h>

namespace physgen::fem::detail {

/// sum + the forces on a node of those of its tets that are in the chunk: column c - 1 of G at corner c > 0, minus all
/// columns at corner 0.
/// @param node_tets Rows of NodeTetEntry
/// @param corners elasticity::CornerForces of the chunk, whose numbers are rounded to Scalar before they are added
template <class Scalar, class NodeTets, class CornerView>
[[nodiscard]] PHYSGEN_FUNCTION inline Vector3<Scalar> add_corners(const TetChunk& chunk, const NodeTets& node_tets,
                                                                  const CornerView& corners, SingleObject auto node,
                                                                  Vector3<Scalar> sum) {
  node_tets.for_each(node, [&](const auto& entry, bool /*active*/) {
    const index_t t = NodeTetEntry::element(entry);
    if (!chunk.has(t)) return;
    const auto tet = corners[t - chunk.first_tet];
    const int corner = NodeTetEntry::local(entry);
    if (corner == 0) {
      const Matrix3<typename CornerView::Precision> all = tet.G();
      sum -= (all.col(0) + all.col(1) + all.col(2)).template cast<Scalar>();
    } else {
      const auto G = tet.G();
      const int first = 3 * (corner - 1);
      sum += Vector3<Scalar>(Scalar(G[first]), Scalar(G[first + 1]), Scalar(G[first + 2]));
    }
  });
  return sum;
}

}  // namespace physgen::fem::detail
