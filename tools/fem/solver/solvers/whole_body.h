// A body on which several ranks find equilibrium, as the solver of one process has it on the host: each rank cuts its
// part out of it.
#pragma once

#include <fem/mesh/stages.h>
#include <fem/solver/arrays/host_points.h>
#include <fem/solver/levels/distributed_levels.h>
#include <fem/solver/solvers/scene_types.h>
#include <fem/solver/solvers/solver_program.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace physgen::fem {

/// A mesh on which equilibrium is sought: the whole one, or what a rank has of it. @tparam Space of its arrays
template <class Space>
struct QuasistaticMesh {
  using Types = SceneTypes<SceneArrays<scenes::quasistatic, Space>>;
  using Choices = typename Types::Level::Choices;
  typename Types::Arrays::Own body;
  scenes::quasistatic_scene::Patches<Space> patches;
  scenes::quasistatic_scene::Chunk<Space> chunk;
  typename Types::Vectors krylov;
  MeshFacts facts;
};

/// With its levels.
template <class Space>
struct QuasistaticBody : QuasistaticMesh<Space> {
  std::vector<typename QuasistaticMesh<Space>::Types::Level::Own> levels;
};

/// All of it, without the arrays that only steps fill. It outlives PartOfEquilibrium's constructor.
struct WholeBody : QuasistaticBody<Host> {
  std::vector<LevelGraph> graphs;
  std::vector<QuasistaticMesh<Host>> coarser;

  WholeBody(const std::vector<MeshLevel>& given, const Loading& loading, const SolverSettings& settings) {
    const InStage stage("arrays of meshes");
    const auto [used, solved] = used_levels(settings, given.size(), given.size());
    graphs = make_level_graphs(std::span(given).first(used));
    levels.resize(used);
    coarser.resize(solved - 1);
    std::vector<Point> motion = loading.motion, forces = loading.forces;
    const auto no_chunk = std::make_shared<scenes::quasistatic_scene::Chunk<>>();
    for (std::size_t l = 0; l < solved; ++l) {
      const MeshLevel& level = given[l];
      Types::Arrays arrays(level, graphs[l], l + 1 < solved, TangentLists::of_edges, no_chunk);
      store_loading(arrays, level.fixed, motion, forces);
      QuasistaticMesh<Host>& mesh = l == 0 ? *this : coarser[l - 1];
      mesh.facts.rounding_force = rounding_force(settings, level, motion, false, arrays.spacing);
      mesh.facts.moves = std::ranges::any_of(level.fixed, [](std::uint8_t fixed) { return fixed != 0; });
      mesh.facts.all_prescribed = std::ranges::all_of(level.fixed, [](std::uint8_t fixed) { return fixed == 7; });
      where(arrays.patches,
            [&](auto& over) { mesh.patches = std::move(static_cast<scenes::quasistatic_scene::Patches<>&>(over)); });
      mesh.body = std::move(static_cast<Types::Arrays::Own&>(arrays));
      if (l + 1 < solved) coarsen_loading(level.parents, given[l + 1].mesh.nodes, motion, forces);
    }
  }
  /// How many levels are cut, whether or not equilibrium is sought on them.
  [[nodiscard]] std::size_t cut(int ranks, std::optional<index_t> replicated) const {
    if (!replicated) return levels_that_are_cut(graphs, ranks);
    std::size_t cut = 1;
    while (cut + 1 < graphs.size() && graphs[cut].nodes > *replicated) ++cut;
    return cut;
  }
};

}  // namespace physgen::fem
