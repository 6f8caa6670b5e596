// Sums at nodes of what a chunk of tets does at its corners.
#pragma once

#include <fem/kernels/load_first.h>
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
#ifdef __CUDA_ARCH__
  // Left to itself, nvcc waits for what a tet has before it asks for that of the next one. The order of sums is the
  // same.
  constexpr int at_once = 8, not_here = -1;
  if (chunk.tets() == 0) return sum;
  const auto range = node_tets.ranges()[node];
  const index_t begin = range.begin(), end = range.end();
  for (index_t first = begin; first < end; first += at_once) {
    typename CornerView::Precision terms[at_once][3];
    index_t tets[at_once];
    int of_corner[at_once];
    PHYSGEN_UNROLL
    for (int u = 0; u < at_once; ++u) {
      const bool is_entry = first + u < end;
      const auto entry = node_tets.entries()[is_entry ? first + u : first];
      const index_t t = NodeTetEntry::element(entry);
      of_corner[u] = is_entry && chunk.has(t) ? NodeTetEntry::local(entry) : not_here;
      tets[u] = chunk.has(t) ? t - chunk.first_tet : 0;
    }
    PHYSGEN_UNROLL
    for (int u = 0; u < at_once; ++u) {
      const auto G = corners[tets[u]].G();
      const int from = of_corner[u] > 0 ? 3 * (of_corner[u] - 1) : 0;
      PHYSGEN_UNROLL
      for (int k = 0; k < 3; ++k) terms[u][k] = G[from + k];
    }
    PHYSGEN_UNROLL
    for (int u = 0; u < at_once; ++u) {
      PHYSGEN_UNROLL
      for (int k = 0; k < 3; ++k) have(terms[u][k]);
    }
    PHYSGEN_UNROLL
    for (int u = 0; u < at_once; ++u) {
      if (of_corner[u] != 0) continue;
      const auto G = corners[tets[u]].G();
      PHYSGEN_UNROLL
      for (int k = 0; k < 3; ++k) terms[u][k] = -(terms[u][k] + G[3 + k] + G[6 + k]);
    }
    PHYSGEN_UNROLL
    for (int u = 0; u < at_once; ++u) {
      if (of_corner[u] == not_here) continue;
      PHYSGEN_UNROLL
      for (int k = 0; k < 3; ++k) sum[k] += Scalar(terms[u][k]);
    }
  }
#else
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
#endif
  return sum;
}

}  // namespace physgen::fem::detail
