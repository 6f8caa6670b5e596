// Fills the arrays of a body in explicit dynamics, which the scene explicit_dynamics declares.
#pragma once

#include <explicit_dynamics.scene.h>
#include <fem/kernels/node_sums.h>
#include <fem/solver/arrays/solver_arrays.h>
#include <fem/solver/elastic/rest_shapes.h>
#include <fem/solver/loads/loading_arrays.h>
#include <fem/solver/quasistatic.h>

#include <type_traits>
#include <vector>

namespace physgen::fem {

/// A way to sum the forces of tets on their corners at nodes.
enum class NodeSums {
  gathered,  ///< from corner forces, in the order of the nodes' rows
  added,     ///< by tets, in an order that is open
  placed     ///< from their places in the nodes' rows, in the order of these
};
/// The fastest, or the fastest whose order is fixed.
template <class Space>
[[nodiscard]] constexpr NodeSums node_sums(bool fixed_order) {
  if (std::is_same_v<Space, Host>) return NodeSums::gathered;
  return fixed_order ? NodeSums::placed : NodeSums::added;
}

/// @tparam Body of scenes::explicit_dynamics_scene
template <class Body>
[[nodiscard]] constexpr typename Body::Counts explicit_counts(index_t nodes, index_t tets, NodeSums sums) {
  const bool gathered = sums == NodeSums::gathered, placed = sums == NodeSums::placed;
  return {.tet = tets,
          .gathered_tet = gathered ? tets : 0,
          .placed_tet = placed ? tets : 0,
          .placed_corner = placed ? 4 * tets : 0,
          .row = gathered || placed ? nodes : 0,
          .gathered_corner = gathered ? 4 * tets : 0,
          .node = nodes};
}

/// Makes the arrays of a body at rest.
/// @param body of scenes::explicit_dynamics_scene
/// @param masses of nodes [kg]
/// @param fixed_order whether sums have the same bits on every run
template <class Body>
void fill_explicit_body(Body& body, const MeshLevel& level, const Loading& loading, const std::vector<double>& masses,
                        bool fixed_order) {
  using HostRows = RowArrays<elasticity::IncidenceRangeArray<float>, elasticity::IncidenceArray<float>>;
  const auto tets = index_t(level.mesh.tets.size());
  const NodeSums sums = node_sums<typename Body::Space>(fixed_order);
  body.allocate(explicit_counts<Body>(level.mesh.nodes, tets, sums));
  put(body.tets, host_tets(level));
  put(body.rest, host_rest_shapes(level));
  const auto rows = incidence_rows<HostRows>(level.mesh.node_tets, tets);
  if (sums != NodeSums::added) put(body.node_tet_ranges, rows.ranges());
  if (sums == NodeSums::gathered) put(body.node_tets, rows.entries());
  if constexpr (!std::is_same_v<typename Body::Space, Host>) {
    if (sums == NodeSums::placed) {
      elasticity::TetPlacesArray<double> places(tets);
      const FindPlaces find{rows.entries().const_view(), places.view()};
      for (index_t entry = 0; entry < 4 * tets; ++entry) find(entry);
      put(body.places, places);
    }
  }
  store_loading(body, level.fixed, loading.motion, loading.forces);
  dynamics::NodeMassArray<double> host_masses(level.mesh.nodes);
  quasistatic::NodeConstraintArray<double> host_constraints(level.mesh.nodes);
  for (index_t n = 0; n < host_masses.size(); ++n) {
    host_masses.view()[n].mass() = masses[std::size_t(n)];
    host_constraints.view()[n].fixed() = level.fixed[std::size_t(n)];
  }
  put(body.masses, host_masses);
  put(body.constraints, host_constraints);
}

}  // namespace physgen::fem
