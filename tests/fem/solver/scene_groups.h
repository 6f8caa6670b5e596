// The groups of arrays of the solver's scenes, filled as the shipped solver fills its own.
#pragma once

#include <fem/mesh/mesh_arrays.h>
#include <fem/solver/equilibrium_arrays.h>
#include <fem/solver/make_linear_levels.h>
#include <fem/solver/solver_program.h>
#include <gtest/gtest.h>
#include <physgen/scene_arrays.h>

#include <vector>

#include "bodies.h"

namespace physgen::fem {

template <class To, class From>
void fill(To& to, const From& from) {
  ASSERT_EQ(to.size(), from.size());
  if constexpr (requires { to.contents(); }) {
    copy(to.contents(), from);
  } else {
    copy(to, from);
  }
}
template <class Ranges, class Entries, class Rows>
void fill_rows(Ranges& ranges, Entries& entries, const Rows& rows) {
  fill(ranges, rows.ranges());
  fill(entries, rows.entries());
}

/// The groups of a scene whose tangents are assembled and whose volumes are averaged over patches, filled with what the
/// shipped solver's arrays are given.
template <class BodyGroup, class Patches, class Chunk, class Level, class Krylov>
struct SceneGroups {
  BodyGroup body;
  Patches patches;
  Chunk chunk;
  std::vector<Level> levels;
  Krylov krylov;
  MeshFacts facts;
  double spacing = 0;  ///< of the finest mesh [m]

  SceneGroups(const Body& given, const SolverSettings& settings) {
    const LevelsInUse used = levels_in_use(given.levels, settings);
    const MeshLevel& finest = used.levels.front();
    EquilibriumArrays<float, Host> mesh(finest, used.graphs.front(), false, TangentLists::of_edges, nullptr);
    store_loading(mesh, finest, given.loading.motion, given.loading.forces);
    const PatchArrays<float, Host>& p = *mesh.patches;
    const index_t tets = mesh.tet_count(), nodes = mesh.nodes(), volumes = mesh.volumes.size();
    const index_t edges = index_t(used.graphs.front().edges.size());
    body.allocate({.tet = tets,
                   .node = nodes,
                   .corner = mesh.node_tets.entries().size(),
                   .edge = edges,
                   .tet_edge = mesh.edge_tets.entries().size(),
                   .volume = volumes});
    fill(body.tets, mesh.tets);
    fill_rows(body.node_tet_ranges, body.node_tet_entries, mesh.node_tets);
    fill_rows(body.edge_tet_ranges, body.edge_tet_entries, mesh.edge_tets);
    for (auto* positions : {&body.positions, &body.kept}) fill(*positions, mesh.rest);
    fill(body.rest, mesh.rest);
    fill(body.loads, mesh.loads);
    fill(body.motion, mesh.motion);
    patches.allocate({.tet = tets, .patch = volumes, .edge = edges, .edge_patch = p.edge_patches.entries().size()});
    fill(patches.tet_patches, p.tet_patches);
    fill(patches.nodes, p.nodes);
    fill_rows(patches.patch_tet_ranges, patches.patch_tet_entries, p.patch_tets);
    fill_rows(patches.edge_patch_ranges, patches.edge_patch_entries, p.edge_patches);
    chunk.allocate({.chunk_tet = mesh.chunk_arrays->corners.size(), .kept_tet = mesh.chunk_arrays->tangent.size()});
    for (const auto& level : make_linear_levels<ShippedLevel>(used, settings)) add(*level);
    krylov.allocate({.node = nodes});
    start_without_values(body.forces.untyped(), {"f"});
    facts.chunks = mesh.chunks;
    facts.rounding_force = rounding_force(settings, finest, given.loading.motion, false, mesh.spacing);
    facts.moves = true;
    spacing = mesh.spacing;
  }

 private:
  using ShippedLevel = LinearLevel<float, Host, StoredAsComputed>;

  void add(ShippedLevel& level) {
    auto& to = levels.emplace_back();
    const index_t nodes = level.nodes();
    to.allocate({.node = nodes,
                 .edge = level.edge_count(),
                 .edge_node = nodes,
                 .edge_end = level.node_edges.entries().size(),
                 .block_node = nodes,
                 .smoother = 1,
                 .child = level.parents.size(),
                 .parent = level.children.size(),
                 .child_entry = level.children.entries().size(),
                 .coarse_edge = level.edge_terms.size(),
                 .edge_term = level.edge_terms.entries().size(),
                 .coarse_pair = level.coarse_inverse.size()});
    fill(to.constraints, level.constraints);
    fill(to.edges, level.edges);
    fill_rows(to.node_edge_ranges, to.node_edge_entries, level.node_edges);
    fill(to.parents, level.parents);
    fill_rows(to.child_ranges, to.child_entries, level.children);
    fill_rows(to.edge_term_ranges, to.edge_term_entries, level.edge_terms);
    facts.sums.push_back(std::move(level.sums));
  }
};

}  // namespace physgen::fem
