// A body on which several ranks find equilibrium, as the solver of one process has it on the host: each rank cuts its
// part out of it.
#pragma once

#include <fem/mesh/stages.h>
#include <fem/solver/arrays/host_points.h>
#include <fem/solver/levels/linear_level.h>
#include <fem/solver/solvers/scene_types.h>
#include <fem/solver/solvers/solver_program.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace physgen::fem {

namespace detail {

/// The group of arrays that a scene has of patches, or NoArrays.
template <class Patches>
struct PatchGroup {
  using type = NoArrays;
};
template <class Group>
struct PatchGroup<std::unique_ptr<PatchesOver<Group>>> {
  using type = Group;
};

}  // namespace detail

/// A mesh on which equilibrium is sought: the whole one, or what a rank has of it.
/// @tparam Space of its arrays @tparam Scene of a row of PHYSGEN_EQUILIBRIUM_SCENES
template <class Space, class Scene = scenes::quasistatic>
struct QuasistaticMesh {
  using Types = SceneTypes<SceneArrays<Scene, Space>>;
  using Choices = typename Types::Level::Choices;
  using Chunk = typename decltype(Types::Arrays::chunk_arrays)::element_type;
  typename Types::Arrays::Own body;
  typename detail::PatchGroup<decltype(Types::Arrays::patches)>::type patches;
  Chunk chunk;
  typename Types::Vectors krylov;
  MeshFacts facts;
};

/// With its levels.
template <class Space, class Scene = scenes::quasistatic>
struct QuasistaticBody : QuasistaticMesh<Space, Scene> {
  std::vector<typename QuasistaticMesh<Space, Scene>::Types::Level::Own> levels;
};

/// All of it, without the arrays that only steps fill. It outlives PartOfEquilibrium's constructor.
template <class Scene = scenes::quasistatic>
struct WholeBody : QuasistaticBody<Host, Scene> {
  using Mesh = QuasistaticMesh<Host, Scene>;
  using Arrays = typename Mesh::Types::Arrays;
  static constexpr bool assembled = Mesh::Choices::assembled;
  std::vector<LevelGraph> graphs;
  std::vector<Mesh> coarser;

  WholeBody(const std::vector<MeshLevel>& given, const Loading& loading, const SolverSettings& settings) {
    const InStage stage("arrays of meshes");
    const auto [used, solved] = used_levels(settings, given.size(), given.size());
    graphs = make_level_graphs(std::span(given).first(used), assembled);
    this->levels.resize(used);
    coarser.resize(solved - 1);
    std::vector<Point> motion = loading.motion, forces = loading.forces;
    const auto no_chunk = std::make_shared<typename Mesh::Chunk>();
    for (std::size_t l = 0; l < solved; ++l) {
      const MeshLevel& level = given[l];
      Arrays arrays(level, graphs[l], l + 1 < solved, assembled ? TangentLists::of_edges : TangentLists::of_nodes,
                    no_chunk);
      store_loading(arrays, level.fixed, motion, forces);
      Mesh& mesh = l == 0 ? *this : coarser[l - 1];
      mesh.facts.rounding_force = rounding_force(settings, level, motion, false, arrays.spacing);
      mesh.facts.moves = std::ranges::any_of(level.fixed, [](std::uint8_t fixed) { return fixed != 0; });
      mesh.facts.all_prescribed = std::ranges::all_of(level.fixed, [](std::uint8_t fixed) { return fixed == 7; });
      where(arrays.patches, [&](auto& over) { mesh.patches = std::move(static_cast<decltype(mesh.patches)&>(over)); });
      mesh.body = std::move(static_cast<typename Arrays::Own&>(arrays));
      if (l + 1 < solved) coarsen_loading(level.parents, given[l + 1].mesh.nodes, motion, forces);
    }
  }
};

}  // namespace physgen::fem
