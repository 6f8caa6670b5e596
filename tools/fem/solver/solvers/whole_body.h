// A body on which several ranks find equilibrium, as the solver of one process has it on the host, or of a box the
// layers that a rank needs: each rank cuts its part out of it.
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

/// Without the arrays that only steps fill. It outlives PartOfEquilibrium's constructor.
struct WholeBody : QuasistaticBody<Host> {
  std::size_t cut;  ///< so many levels are cut, whether or not equilibrium is sought on them
  std::vector<LevelGraph> graphs;
  ListedLevels listed;  ///< what graphs and arrays have
  std::vector<QuasistaticMesh<Host>> coarser;

  /// @param replicated coarser meshes of more nodes are cut; or as levels_that_are_cut() says
  WholeBody(const Ranks& ranks, const std::vector<MeshLevel>& given, const Loading& loading,
            const SolverSettings& settings, std::optional<index_t> replicated) {
    const InStage stage("arrays of meshes");
    const auto [used, solved] = used_levels(settings, given.size(), given.size());
    const auto in_use = std::span(given).first(used);
    std::vector<index_t> nodes;
    for (const MeshLevel& level : given) nodes.push_back(level.mesh.nodes);
    cut = levels_cut_by_solver(nodes, settings, ranks.count(), replicated);
    PartOfLevels part = part_of_levels(in_use, cut, ranks.rank(), ranks.count());
    graphs = std::move(part.graphs);
    listed = std::move(part.listed);
    levels.resize(used);
    coarser.resize(solved - 1);
    std::vector<Point> motion = loading.motion, forces = loading.forces;
    const auto no_chunk = std::make_shared<scenes::quasistatic_scene::Chunk<>>();
    for (std::size_t l = 0; l < solved; ++l) {
      const MeshLevel& level = given[l];
      const MeshLevel& here = l < part.levels.size() ? part.levels[l] : level;
      Types::Arrays arrays(here, graphs[l], l + 1 < solved, TangentLists::of_edges, no_chunk);
      const auto here_of = [&](const std::vector<Point>& of_nodes) {
        const auto first = of_nodes.begin() + (of_nodes.empty() ? 0 : listed.of(l, graphs[l]).nodes.offset);
        return std::vector<Point>(first, first + (of_nodes.empty() ? 0 : here.mesh.nodes));
      };
      store_loading(arrays, here.fixed, here_of(motion), here_of(forces));
      QuasistaticMesh<Host>& mesh = l == 0 ? *this : coarser[l - 1];
      const double spacing = mean_spacing(level.mesh, level.rest);
      mesh.facts.rounding_force = l < part.levels.size() ? rounding_force_of_box(settings, level, motion, spacing)
                                                         : rounding_force(settings, level, motion, false, spacing);
      mesh.facts.moves = std::ranges::any_of(level.fixed, [](std::uint8_t fixed) { return fixed != 0; });
      mesh.facts.all_prescribed = std::ranges::all_of(level.fixed, [](std::uint8_t fixed) { return fixed == 7; });
      where(arrays.patches,
            [&](auto& over) { mesh.patches = std::move(static_cast<scenes::quasistatic_scene::Patches<>&>(over)); });
      mesh.body = std::move(static_cast<Types::Arrays::Own&>(arrays));
      if (l < part.levels.size()) part.levels[l] = {};
      if (l + 1 < solved) coarsen_loading(level.parents, given[l + 1].mesh.nodes, motion, forces);
    }
  }
  /// Keeps what arrays are filled with behind cut().
  void release_lists() {
    for (LevelGraph& graph : graphs) {
      LevelGraph kept;
      kept.nodes = graph.nodes;
      kept.is_grid = graph.is_grid;
      kept.fixed = std::move(graph.fixed);
      kept.grid_parents = std::move(graph.grid_parents);
      graph = std::move(kept);
    }
    release_lists_of(*this);
    for (QuasistaticMesh<Host>& mesh : coarser) release_lists_of(mesh);
  }

 private:
  /// rounding_force() of a mesh of whose nodes each has tets, whether or not there are lists.
  static double rounding_force_of_box(const SolverSettings& settings, const MeshLevel& level,
                                      const std::vector<Point>& motion, double spacing) {
    double farthest = 0;
    for (std::size_t n = 0; n < level.rest.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) {
        farthest = std::max(farthest, std::abs(level.rest[n][k]) + std::abs(motion[n][k]));
      }
    }
    return rounding_force(node_stiffness(settings, false, spacing), farthest, level.rest.size());
  }
  static void release_lists_of(QuasistaticMesh<Host>& mesh) {
    Types::Arrays::Own kept;
    kept.rest = std::move(mesh.body.rest);
    kept.loads = std::move(mesh.body.loads);
    kept.motion = std::move(mesh.body.motion);
    kept.state = std::move(mesh.body.state);
    kept.volumes = std::move(mesh.body.volumes);
    mesh.body = std::move(kept);
    mesh.patches = scenes::quasistatic_scene::Patches<>();
  }
};

}  // namespace physgen::fem
