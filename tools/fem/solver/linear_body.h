// The arrays of a linear elastic body, by name, and products with its stiffness: ten numbers are kept per tet, its
// shape at rest.
#pragma once

#include <fem/solver/linear_elastic.h>
#include <fem/solver/rest_shapes.h>
#include <fem/solver/solver_arrays.h>

namespace physgen::fem {

template <class Real_, class Space_>
struct LinearBody {
  using Real = Real_;
  using Space = Space_;

  elasticity::TetArray<Real, Space> tets;
  elasticity::RestShapeArray<double, Space> rest;
  // Rows of NodeTetEntry, and where the stiffness is assembled of EdgeTetEntry.
  elasticity::IncidenceRangeArray<float, Space> node_tet_ranges, edge_tet_ranges;
  quasistatic::PackedIncidenceArray<float, Space> node_tets, edge_tets;

  elasticity::NodeDisplacementArray<double, Space> displacements;  ///< u, from rest
  elasticity::NodeDisplacementArray<double, Space> motion;         ///< of prescribed components, at a load of 1
  elasticity::NodeForceArray<double, Space> loads;                 ///< external, at a load of 1
  elasticity::NodeForceArray<double, Space> forces;  ///< elastic and external; in prescribed components -reaction
  quasistatic::EquilibriumArray<double, Space> state;

  LinearBody(const MeshLevel& level, const LevelGraph& graph, bool assembled)
      : tets(moved_to<decltype(tets)>(host_tets(level))),
        rest(moved_to<decltype(rest)>(host_rest_shapes(level))),
        displacements(graph.nodes),
        motion(graph.nodes),
        loads(graph.nodes),
        forces(graph.nodes),
        state(1) {
    const PackedRows<Host> of_nodes = packed_rows<NodeTetEntry>(level.mesh.node_tets, tets.size(), "tets");
    node_tet_ranges = moved_to<decltype(node_tet_ranges)>(of_nodes.ranges());
    node_tets = moved_to<decltype(node_tets)>(of_nodes.entries());
    if (!assembled) return;
    const PackedRows<Host> of_edges =
        packed_rows<EdgeTetEntry>(make_edge_parts(level, graph).edge_tets, tets.size(), "tets");
    edge_tet_ranges = moved_to<decltype(edge_tet_ranges)>(of_edges.ranges());
    edge_tets = moved_to<decltype(edge_tets)>(of_edges.entries());
  }

  [[nodiscard]] index_t nodes() const { return displacements.size(); }
  [[nodiscard]] index_t bytes() const {
    return bytes_of(tets, rest, node_tet_ranges, node_tets, edge_tet_ranges, edge_tets, displacements, motion, loads,
                    forces, state);
  }
};

/// The tets of each node.
template <class Body>
[[nodiscard]] auto node_tets_of(const Body& a) {
  return Rows(a.node_tet_ranges.const_view(), a.node_tets.const_view(), a.tets.size());
}

/// Forces on nodes at displacements u, in the precision Scalar. @param a LinearBody, or arrays of its names
template <class Scalar, class Body, class DisplacementView>
[[nodiscard]] auto forces_of(const Body& a, const LameParameters& lame, const DisplacementView& u) {
  return linear_force<Scalar>(lame, a.tets.const_view(), a.rest.const_view(), node_tets_of(a), u);
}

}  // namespace physgen::fem
