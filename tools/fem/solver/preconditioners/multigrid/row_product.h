// Products of edges' blocks that lie by rows of nodes (edge_rows.h).
#pragma once

#include <fem/kernels/edge_rows.h>
#include <fem/numerics/scalar.h>
#include <fem/solver/arrays/packed_rows.h>
#include <fem/solver/row_sums.h>
#include <physgen/kernel.h>

namespace physgen::fem {

/// df += what the edges have of K dx; see run_rows().
template <class EdgeStiffnessView, class DisplacementView, class DifferentialView>
struct AddRowProduct {
  using Scalar = typename DifferentialView::Precision;
  EdgeRows::View rows;
  EdgeStiffnessView edge_stiffness;  ///< elasticity::EdgeStiffness of each entry, seen from the row's node
  DisplacementView displacements;    ///< elasticity::NodeDisplacement
  DifferentialView differentials;    ///< elasticity::NodeForceDifferential

  static constexpr int lanes = 8;
  using Vector = Vector3<Scalar>;

  PHYSGEN_FUNCTION Vector part(SingleObject auto node, Lane lane) const {
    constexpr int at_once = 4;  // loads of so many blocks are under way together, before the sum needs the first
    const Index begin = rows.first[object_number(node)], end = rows.first[object_number(node) + 1];
    Vector sum = Vector::Zero();
    if (lane.number == 0) sum = differentials[node].df();  // under way with the blocks, too
    for (Index first = begin + lane.number; first < end; first += at_once * lane.count) {
      Matrix3<Scalar> E[at_once];
      Vector dx[at_once];
      PHYSGEN_UNROLL
      for (int t = 0; t < at_once; ++t) {
        const Index entry = first + t * lane.count < end ? first + t * lane.count : first;
        E[t] = edge_stiffness[index_t{entry}].E();
        dx[t] = displacements[index_t{rows.others[entry]}].dx();
      }
      PHYSGEN_UNROLL
      for (int t = 0; t < at_once; ++t) {
        if (first + t * lane.count < end) sum = multiply_add<Scalar>(E[t], dx[t], sum);
      }
    }
    return sum;
  }
  PHYSGEN_FUNCTION void put(SingleObject auto node, const Vector& sum) const { differentials[node].df() = sum; }
  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const { put(node, part(node, Lane{})); }
};

/// Runs a kernel over edges once for each entry of rows: kernel(edge, entry, side).
template <class Kernel, class EntryView>
struct AtEntries {
  using Scalar = typename Kernel::Scalar;
  Kernel kernel;
  EntryView entries;  ///< of a level's node_edges: NodeEdgeEntry

  PHYSGEN_FUNCTION void operator()(SingleObject auto entry) const {
    const auto value = entries[entry];
    kernel(NodeEdgeEntry::element(value), entry, NodeEdgeEntry::local(value));
  }
};

}  // namespace physgen::fem
