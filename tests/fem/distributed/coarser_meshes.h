// The meshes below the finest on which equilibrium is sought first: whole, and what one of several ranks has of them.
#pragma once

#include <fem/solver/loads/loading_arrays.h>

#include <string>
#include <utility>
#include <vector>

#include "newton_runs.h"

namespace physgen::fem {

/// @tparam Whole SceneGroups
template <class Whole>
using CoarserMeshOf = CoarserMesh<decltype(Whole::body), decltype(Whole::chunk), decltype(Whole::krylov)>;

/// The next finest first, each with the loading that it has of the finest.
/// @param note note(whole, body) notes further facts of a mesh, the finest of that body
template <class Whole, class Note>
[[nodiscard]] std::vector<CoarserMeshOf<Whole>> coarser_meshes(Body body, const SolverSettings& settings,
                                                               const Note& note) {
  const std::size_t solved = used_levels(settings, body.levels.size(), body.levels.size()).solved;
  std::vector<CoarserMeshOf<Whole>> meshes;
  while (meshes.size() + 1 < solved) {
    coarsen_loading(body.levels.front().parents, body.levels[1].mesh.nodes, body.loading.motion, body.loading.forces);
    body.levels.erase(body.levels.begin());
    Whole whole(body, settings);
    note(whole, body);
    meshes.push_back({std::move(whole.body), std::move(whole.chunk), std::move(whole.krylov), std::move(whole.facts)});
  }
  return meshes;
}

/// @tparam Mesh CoarserMesh
template <class Mesh>
struct CoarserParts {
  std::vector<Mesh> parts, whole{};  ///< where `parts` are what a rank has of them

  /// @param levels_cut how many of all levels are cut, of which the finest is none of these meshes
  void add_to(DistributedArrays& arrays, std::size_t levels_cut) {
    whole = std::exchange(parts, std::vector<Mesh>(parts.size()));
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const std::string number = "[" + std::to_string(k + 1) + "]", level = "level" + number, tet = "tet" + number;
      if (k + 1 < levels_cut) {
        arrays.add_set(tet, whole[k].body.tets.size());
        arrays.follow(tet, level + ".node");
      } else {
        arrays.add_replicated_set(tet, whole[k].body.tets.size());
      }
      const auto& body = whole[k].body;
      const ListedLevel listed{{body.rest.size()}, {body.edge_tet_ranges.size()}, {body.tets.size()}, {}};
      add_mesh(arrays, number, {level + ".node", tet, tet, tet}, parts[k].body, parts[k].chunk, parts[k].krylov, body,
               listed, false);
      add_edge_tets(arrays, number, level + ".edge", tet, parts[k].body, body, listed);
    }
  }
  /// @param levels those of all meshes
  template <class Levels>
  void fill(DistributedArrays& arrays, Levels& levels) {
    for (std::size_t k = 0; k < parts.size(); ++k) {
      Mesh& mesh = parts[k];
      fill_mesh(arrays, mesh.body, mesh.krylov, whole[k].body, {whole[k].body.rest.size()});
      mesh.facts.rounding_force = whole[k].facts.rounding_force;
      mesh.facts.plane_stiffness = whole[k].facts.plane_stiffness;
      mesh.facts.moves = whole[k].facts.moves;
      mesh.facts.chunks = chunks_of_part<true>(arrays.transport(), mesh.body, levels[k + 1].edges.contents());
    }
  }
  template <class Each>
  void print(const Digests<Each>& digests) const {
    for (const Mesh& mesh : parts) {
      digests.print("coarser positions", mesh.body.positions,
                    [](const auto& node, int k) -> double { return node.x()[k]; });
      digests.print("coarser forces", mesh.body.forces, [](const auto& node, int k) -> double { return node.f()[k]; });
    }
  }
};

}  // namespace physgen::fem
