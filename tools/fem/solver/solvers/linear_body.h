// Fills the arrays of a linear elastic body, those of Linear in solver_groups.h.
#pragma once

#include <fem/solver/arrays/solver_arrays.h>
#include <fem/solver/elastic/linear_elastic.h>
#include <fem/solver/elastic/rest_shapes.h>
#include <fem/solver/hierarchy/level_counts.h>
#include <fem/solver/loads/loading_arrays.h>
#include <fem/solver/quasistatic.h>

namespace physgen::fem {

/// @tparam Body the group Linear of a scene
template <class Body>
[[nodiscard]] typename Body::Counts linear_counts(const LevelCounts& mesh, bool assembled) {
  return {.tet = mesh.tets,
          .node = mesh.nodes,
          .corner = 4 * mesh.tets,
          .edge = assembled ? mesh.edges : 0,
          .tet_edge = assembled ? 6 * mesh.tets : 0};
}

/// Makes the arrays of a body at rest.
/// @param body the group Linear of a scene
/// @param assembled whether the stiffness is
template <class Body>
void fill_linear_body(Body& body, const MeshLevel& level, const LevelGraph& graph, const Loading& loading,
                      bool assembled) {
  const auto tets = index_t(level.mesh.tets.size());
  body.allocate(linear_counts<Body>(counts_of(level, graph), assembled));
  put(body.tets, host_tets(level));
  put(body.rest, host_rest_shapes(level));
  put_packed<NodeTetEntry>(body.node_tet_ranges, body.node_tets, level.mesh.node_tets, tets, "tets");
  if (assembled) {
    put_packed<EdgeTetEntry>(body.edge_tet_ranges, body.edge_tets, make_edge_parts(level, graph).edge_tets, tets,
                             "tets");
  }
  store_loading(body, level.fixed, loading.motion, loading.forces);
}

}  // namespace physgen::fem
