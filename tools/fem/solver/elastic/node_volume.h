// Kernels of averaged nodal volumes (Bonet and Burton 1998), against locking at Poisson's ratios near 1/2 on any mesh:
// a node has a quarter of each of its tets, the energy is sum V psi_shear(F) over tets + sum V_a U(T_a) over nodes, and
// a tet has the mean of the pressures of its corners. A node's volume depends on the node and its neighbours, its ring;
// so the tangent's k g g^T join nodes that are two edges apart. Pressures are linearised as those of patches.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/solver/arrays/packed_rows.h>
#include <fem/solver/elastic/evaluate_tets.h>
#include <fem/solver/elastic/mean_volume.h>
#include <physgen/rows.h>

namespace physgen::fem {

namespace detail {

/// Where a node is among the entries begin .. end-1 of a ring, which ascend. @pre it is one of them
template <class RingNodeView>
PHYSGEN_FUNCTION inline index_t place_in_ring(const RingNodeView& entries, index_t begin, index_t end, index_t node) {
  while (end - begin > 1) {
    const index_t middle = begin + (end - begin) / 2;
    if (index_t{entries[middle].node()} <= node) {
      begin = middle;
    } else {
      end = middle;
    }
  }
  return begin;
}

}  // namespace detail

/// Volumes [m^3] and T of nodes, their pressures and k, and how each node changes the volumes of its ring.
template <class NodeTets, class TetView, class RestView, class PositionView, class MeanVolumeView, class Rings,
          class TangentView>
struct EvaluateNodeVolumes {
  using Scalar = typename MeanVolumeView::Precision;
  VolumeLaw law;
  Scalar modulus;          ///< lambda or kappa [Pa]
  bool restart;            ///< the linearised pressure begins anew, at that of the forces
  NodeTets node_tets;      ///< Rows of NodeTetEntry
  TetView tets;            ///< elasticity::Tet
  RestView rest;           ///< elasticity::NodePosition, at rest
  PositionView positions;  ///< elasticity::NodePosition, current
  MeanVolumeView volumes;  ///< quasistatic::MeanVolume, of which `linearised` is read unless restart; written
  Rings rings;             ///< Rows of quasistatic::RingNode, of which g is written
  TangentView tangent;     ///< quasistatic::NodeVolumeTangent, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Real = typename TangentView::Precision;
    using Vector = Vector3<Scalar>;
    const auto entries = rings.entries();
    const auto range = rings.ranges()[node];
    const index_t begin = range.begin(), end = range.end();
    for (index_t entry = begin; entry < end; ++entry) entries[entry].g().setZero();
    Scalar volume = 0, current = 0;
    node_tets.for_each(node, [&](const auto& entry, bool /*active*/) {
      const index_t t = NodeTetEntry::element(entry);
      const int corner = NodeTetEntry::local(entry);
      const detail::TetVolume<Scalar> tet = detail::tet_volume<Scalar>(tets, rest, positions, t);
      volume += tet.rest;
      current += tet.current;
      const Vector change = corner == 0 ? Vector(-tet.minus_first) : corner == 1 ? tet.j : corner == 2 ? tet.k : tet.l;
      const auto corners = tets[t].nodes();
      for (int c = 0; c < 4; ++c) {
        const auto g = entries[detail::place_in_ring(entries, begin, end, index_t{corners[c]})].g();
        for (int k = 0; k < 3; ++k) g[k] += static_cast<Real>(change[k] / Scalar(24));
      }
    });
    tangent[node].k() = static_cast<Real>(
        detail::respond<Scalar>(law, modulus, restart, volume / Scalar(24), current / Scalar(24), volumes[node]));
  }
};

/// The pressure of a tet is the mean of those of its corners.
template <class TetView, class MeanVolumeView>
struct NodePressures {
  static constexpr bool averages = true;
  TetView tets;            ///< elasticity::Tet
  MeanVolumeView volumes;  ///< quasistatic::MeanVolume, per node

  template <class S, class I>
  PHYSGEN_FUNCTION TetPressure<S> of(I tet) const {
    using Node = lanes_t<std::int32_t, I>;
    const auto nodes = tets[tet].nodes();
    const Node first = nodes[0], second = nodes[1], third = nodes[2], fourth = nodes[3];
    const auto a = volumes[first], b = volumes[second], c = volumes[third], d = volumes[fourth];
    const S quarter(RealOf<S>(0.25));
    const S sum = (S(a.pressure()) + S(b.pressure())) + (S(c.pressure()) + S(d.pressure()));
    const S tangent_sum =
        (S(a.tangent_pressure()) + S(b.tangent_pressure())) + (S(c.tangent_pressure()) + S(d.tangent_pressure()));
    return {quarter * sum, quarter * tangent_sum};
  }
};

/// E(m, n) -= k_a g_am g_an^T of the nodes a that have both ends of the edge in their rings.
template <class EdgeView, class Rings, class TangentView, class EdgeStiffnessView>
struct AddNodeVolumeStiffness {
  using Scalar = typename EdgeStiffnessView::Precision;
  EdgeView ends;            ///< elasticity::Edge
  Rings rings;              ///< Rows of quasistatic::RingNode
  TangentView tangent;      ///< quasistatic::NodeVolumeTangent
  EdgeStiffnessView edges;  ///< elasticity::EdgeStiffness

  PHYSGEN_FUNCTION void operator()(SingleObject auto edge) const {
    using Vector = Vector3<Scalar>;
    const auto names = ends[edge].nodes();
    const index_t m = names[0], n = names[1];
    const auto entries = rings.entries();
    const auto range_m = rings.ranges()[m], range_n = rings.ranges()[n];
    const index_t end_m = range_m.end(), end_n = range_n.end();
    Matrix3<Scalar> sum = edges[edge].E();
    for (index_t i = range_m.begin(), j = range_n.begin(); i < end_m && j < end_n;) {
      const index_t a = entries[i].node(), b = entries[j].node();
      if (a == b) {
        const Vector g_m = entries[i].g(), g_n = entries[j].g();
        const Vector kg_m = g_m * Scalar(tangent[a].k());
        for (int c = 0; c < 3; ++c) sum.col(c) -= kg_m * g_n[c];
      }
      if (a <= b) ++i;
      if (b <= a) ++j;
    }
    edges[edge].E() = sum;
  }
};

/// Moves the linearised pressure along with a step dx that Newton's method takes from the state of the last
/// EvaluateNodeVolumes.
template <class MeanVolumeView, class Rings, class DisplacementView>
struct AdvanceNodeVolumes {
  using Scalar = typename MeanVolumeView::Precision;
  VolumeLaw law;
  Scalar modulus;                  ///< lambda or kappa [Pa]
  MeanVolumeView volumes;          ///< quasistatic::MeanVolume
  Rings rings;                     ///< Rows of quasistatic::RingNode
  DisplacementView displacements;  ///< elasticity::NodeDisplacement: dx

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    Scalar change = 0;  // of the node's volume, with the nodes of its ring
    const auto entries = rings.entries();
    rings.for_each(node, [&](const auto& entry, bool /*active*/) {
      const index_t other = entry.node();
      const auto range = rings.ranges()[other];
      const auto g =
          entries[detail::place_in_ring(entries, index_t{range.begin()}, index_t{range.end()}, object_number(node))]
              .g();
      const auto dx = displacements[other].dx();
      for (int k = 0; k < 3; ++k) change += Scalar(g[k]) * Scalar(dx[k]);
    });
    detail::advance<Scalar>(law, modulus, change, volumes[node]);
  }
};

/// A node begins with the mean of the linearised pressures that the coarser level has found at its parents.
template <class ParentsView, class CoarseView, class MeanVolumeView>
struct InjectNodePressures {
  using Scalar = typename MeanVolumeView::Precision;
  ParentsView parents;     ///< quasistatic::NodeParents
  CoarseView coarse;       ///< quasistatic::MeanVolume
  MeanVolumeView volumes;  ///< quasistatic::MeanVolume

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    const auto names = parents[node].nodes();
    const index_t first = names[0], second = names[1];
    volumes[node].linearised() =
        Scalar(0.5) * (Scalar(coarse[first].linearised()) + Scalar(coarse[second].linearised()));
  }
};

}  // namespace physgen::fem

#pragma pop_macro("I")
