// Fills the arrays of a body in explicit dynamics, which the scene explicit_dynamics declares.
#pragma once

#include <explicit_dynamics.scene.h>
#include <fem/solver/loading_arrays.h>
#include <fem/solver/quasistatic.h>
#include <fem/solver/rest_shapes.h>
#include <fem/solver/solver_arrays.h>

#include <vector>

namespace physgen::fem {

/// @tparam Body of scenes::explicit_dynamics_scene
template <class Body>
[[nodiscard]] constexpr typename Body::Counts explicit_counts(index_t nodes, index_t tets) {
  return {.tet = tets, .node = nodes, .corner = 4 * tets};
}

/// Makes the arrays of a body at rest.
/// @param body of scenes::explicit_dynamics_scene
/// @param masses of nodes [kg]
template <class Body>
void fill_explicit_body(Body& body, const MeshLevel& level, const Loading& loading, const std::vector<double>& masses) {
  using HostRows = RowArrays<elasticity::IncidenceRangeArray<float>, elasticity::IncidenceArray<float>>;
  const auto tets = index_t(level.mesh.tets.size());
  body.allocate(explicit_counts<Body>(level.mesh.nodes, tets));
  put(body.tets, host_tets(level));
  put(body.rest, host_rest_shapes(level));
  const auto rows = incidence_rows<HostRows>(level.mesh.node_tets, tets);
  put(body.node_tet_ranges, rows.ranges());
  put(body.node_tets, rows.entries());
  store_loading(body, level, loading.motion, loading.forces);
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
