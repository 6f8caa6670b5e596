// A body on which several ranks find equilibrium, as the solver of one process has it on the host, or of a box the
// layers that a rank needs: each rank cuts its part out of it.
#pragma once

#include <fem/mesh/stages.h>
#include <fem/solver/arrays/host_points.h>
#include <fem/solver/levels/layers_of_levels.h>
#include <fem/solver/levels/linear_level.h>
#include <fem/solver/solvers/scene_types.h>
#include <fem/solver/solvers/solver_program.h>
#include <physgen/distributed/ranks.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace physgen::fem {

namespace detail {

/// The group of arrays that an Optional of a scene is over, or NoArrays.
template <class Optional>
struct OwnGroup {
  using type = NoArrays;
};
template <template <class> class Over, class Group>
struct OwnGroup<std::unique_ptr<Over<Group>>> {
  using type = Group;
};

}  // namespace detail

/// A mesh on which equilibrium is sought: the whole one, or what a rank has of it.
/// @tparam Space of its arrays @tparam Scene of a row of PHYSGEN_EQUILIBRIUM_SCENES, or EverythingOnRanks
template <class Space, class Scene = scenes::quasistatic>
struct QuasistaticMesh {
  using Types = SceneTypes<SceneArrays<Scene, Space>>;
  using Choices = typename Types::Level::Choices;
  using Chunk = typename decltype(Types::Arrays::chunk_arrays)::element_type;
  typename Types::Arrays::Own body;
  typename detail::OwnGroup<decltype(Types::Arrays::patches)>::type patches;
  Chunk chunk;
  typename Types::Vectors krylov;
  MeshFacts facts;
  std::vector<MaterialRange> materials;  ///< where there are several
};

/// Such a mesh with the levels of its linear solves, and rigid planes.
template <class Space, class Scene = scenes::quasistatic>
struct QuasistaticBody : QuasistaticMesh<Space, Scene> {
  using Level = typename QuasistaticMesh<Space, Scene>::Types::Level;
  using Planes = typename detail::OwnGroup<decltype(Level::planes)>::type;
  std::vector<typename Level::Own> levels;
  std::vector<Planes> planes;  ///< of the level of each mesh, where the body may touch some; else none
};

/// The arrays that are filled before the first step. It outlives PartOfEquilibrium's constructor.
template <class Scene = scenes::quasistatic>
struct WholeBody : QuasistaticBody<Host, Scene> {
  using Mesh = QuasistaticMesh<Host, Scene>;
  using Arrays = typename Mesh::Types::Arrays;
  static constexpr bool assembled = Mesh::Choices::assembled;
  std::size_t cut;  ///< so many levels are cut, whether or not equilibrium is sought on them
  std::vector<LevelGraph> graphs;
  ListedLevels listed;  ///< what graphs and arrays have
  std::vector<Mesh> coarser;
  // Of all nodes of the meshes on which equilibrium is sought, as MeshLevel has them: loads are coarsened by these.
  std::vector<std::vector<std::uint8_t>> fixed;
  std::vector<std::vector<std::array<Index, 2>>> parents;  ///< of all but the coarsest of these

  /// @param replicated as levels_that_are_cut() takes it
  WholeBody(const Ranks& ranks, const std::vector<MeshLevel>& given, const Loading& loading,
            const SolverSettings& settings, std::optional<index_t> replicated) {
    const InStage stage("arrays of meshes");
    const auto meshes = static_cast<std::size_t>(std::ranges::find_if(given, &MeshLevel::is_grid) - given.begin());
    const auto [used, solved] = used_levels(settings, given.size(), meshes);
    std::vector<index_t> nodes;
    for (const MeshLevel& level : given) nodes.push_back(level.is_grid() ? 0 : level.mesh.nodes);
    cut = levels_cut_by_solver(nodes, settings, ranks.count(), replicated);
    const bool has_planes = !loading.planes.empty();
    PartOfLevels part = part_of_levels(std::span(given).first(used), cut, ranks.rank(), ranks.count(), assembled);
    graphs = std::move(part.graphs);
    listed = std::move(part.listed);
    this->levels.resize(used);
    coarser.resize(solved - 1);
    std::vector<Point> motion = loading.motion, forces = loading.forces;
    const auto no_chunk = std::make_shared<typename Mesh::Chunk>();
    for (std::size_t l = 0; l < solved; ++l) {
      const MeshLevel& level = given[l];
      const bool is_part = l < part.levels.size();
      const MeshLevel& here = is_part ? part.levels[l] : level;
      Arrays arrays(here, graphs[l], l + 1 < solved, assembled ? TangentLists::of_edges : TangentLists::of_nodes,
                    no_chunk);
      const auto here_of = [&, first = listed.of(l, graphs[l]).nodes.offset](const std::vector<Point>& of_nodes) {
        if (of_nodes.empty()) return std::vector<Point>();
        return std::vector<Point>(of_nodes.begin() + first, of_nodes.begin() + first + here.mesh.nodes);
      };
      store_loading(arrays, here.fixed, here_of(motion), here_of(forces));
      Mesh& mesh = l == 0 ? *this : coarser[l - 1];
      const double spacing = mean_spacing(level.mesh, level.rest);
      mesh.facts.rounding_force = rounding_force(settings, level, motion, has_planes, spacing);
      mesh.facts.plane_stiffness = settings.plane_stiffness * settings.youngs_modulus / spacing;
      mesh.facts.moves = has_planes || std::ranges::any_of(level.fixed, [](std::uint8_t held) { return held != 0; });
      mesh.facts.all_prescribed = std::ranges::all_of(level.fixed, [](std::uint8_t held) { return held == 7; });
      where(arrays.patches, [&](auto& over) { mesh.patches = std::move(static_cast<decltype(mesh.patches)&>(over)); });
      mesh.body = std::move(static_cast<typename Arrays::Own&>(arrays));
      mesh.materials = arrays.materials;
      if (is_part) part.levels[l] = {};
      fixed.push_back(level.fixed);
      if (l + 1 == solved) break;
      parents.push_back(level.parents);
      coarsen_loading(level.parents, given[l + 1].mesh.nodes, motion, forces);
    }
    if (has_planes) make_planes(std::span(given).first(std::min(used, meshes)), loading.planes);
  }
  /// Releases all but what arrays are filled with behind cut().
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
    for (Mesh& mesh : coarser) release_lists_of(mesh);
  }

 private:
  /// Makes the planes, and the areas [m^2] of all nodes of meshes on which equilibrium is sought.
  void make_planes(std::span<const MeshLevel> given, const std::vector<RigidPlane>& of_loading) {
    if constexpr (may_have<decltype(WholeBody::Level::planes)>) {
      using Over = GroupOf<decltype(WholeBody::Level::planes)>;
      for (std::size_t l = 0; l < given.size(); ++l) {
        typename WholeBody::Planes& planes = this->planes.emplace_back();
        if (l > coarser.size()) continue;
        planes = Over(given[l], of_loading, 0);
        planes.stiffness = decltype(planes.stiffness)();
      }
    }
  }
  static void release_lists_of(Mesh& mesh) {
    typename Arrays::Own kept;
    kept.rest = std::move(mesh.body.rest);
    kept.loads = std::move(mesh.body.loads);
    kept.motion = std::move(mesh.body.motion);
    kept.state = std::move(mesh.body.state);
    kept.volumes = std::move(mesh.body.volumes);
    mesh.body = std::move(kept);
    mesh.patches = decltype(mesh.patches)();
  }
};

}  // namespace physgen::fem
