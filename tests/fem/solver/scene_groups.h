// The groups of arrays of the solver's scenes, filled as the shipped solver fills its own.
#pragma once

#include <fem/mesh/mesh_arrays.h>
#include <fem/solver/preconditioners/make_linear_levels.h>
#include <fem/solver/solvers/solver_program.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "bodies.h"

namespace physgen::fem {

/// @tparam Patches over which volumes are averaged, or NoArrays
/// @tparam Choices of the scene's program: AssembledOnMeshes or ByTets
template <class BodyGroup, class Patches, class Chunk, class LevelGroup, class Krylov,
          class Choices_ = AssembledOnMeshes>
struct SceneGroups {
  using Choices = Choices_;
  BodyGroup body;
  Patches patches;
  Chunk chunk;
  std::vector<LevelGroup> levels;
  std::vector<LevelGraph> graphs;  ///< of the levels
  Krylov krylov;
  MeshFacts facts;
  double spacing = 0;  ///< of the finest mesh [m]

  /// @pre the settings' product is that of the choices
  SceneGroups(const Body& given, const SolverSettings& settings) {
    using Mesh = EquilibriumOver<float, BodyGroup, OverGroup<PatchesOver, Patches>, NoArrays, Chunk>;
    using Level = LevelOver<float, Host, StoredAsComputed, Choices, LevelGroup, NoArrays, NoArrays, NoArrays>;
    constexpr TangentLists lists = Choices::assembled ? TangentLists::of_edges : TangentLists::of_nodes;
    LevelsInUse used = levels_in_use(given.levels, settings);
    const MeshLevel& finest = used.levels.front();
    Mesh mesh(finest, used.graphs.front(), false, lists, nullptr);
    store_loading(mesh, finest.fixed, given.loading.motion, given.loading.forces);
    facts.chunks = mesh.chunks;
    facts.rounding_force = rounding_force(settings, finest, given.loading.motion, false, mesh.spacing);
    facts.nodes = finest.mesh.nodes;
    facts.moves = true;
    spacing = mesh.spacing;
    body = std::move(mesh);
    where(mesh.patches, [&](auto& over) { patches = std::move(over); });
    chunk = std::move(*mesh.chunk_arrays);
    graphs = make_level_graphs(used.levels, Choices::assembled);
    if (const auto grid = std::ranges::find_if(graphs, &LevelGraph::is_grid); grid != graphs.end()) {
      facts.meshes = static_cast<std::size_t>(grid - graphs.begin());
    }
    for (auto& level : make_linear_levels<Level>(used, settings)) {
      facts.sums.push_back(std::move(level->sums));
      levels.push_back(std::move(*level));
    }
    krylov.allocate({.node = body.rest.size()});
    start_without_values(body.forces.untyped(), {"f"});
  }
};

}  // namespace physgen::fem
