// What one of several ranks has of the arrays on which a scene seeks equilibrium, cut from those of the whole mesh,
// which are filled as the solver fills its own.
#pragma once

#include <fem/solver/levels/distributed_levels.h>
#include <fem/solver/solvers/chunks_of_part.h>
#include <fem/solver/solvers/names_of_lists.h>
#include <fem/solver/solvers/solver_program.h>
#ifdef __CUDACC__
#include <physgen/distributed/cuda/executor.h>
#else
#include <physgen/distributed/executor.h>
#endif

#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace physgen::fem {

/// Names of the sets of a mesh; tets of chunks, and those whose tangents are kept, may be counted apart.
struct MeshSets {
  std::string node, tet, chunk_tet, kept_tet;
};
/// Adds and connects the arrays of a mesh and of its linear solves, without those of its edges.
/// @param number of the mesh where there are several, as "[1]" @param listed the objects of all that `whole` has
/// @param keeps_tangents of all tets, as where tangents are not assembled
template <class Body, class Chunk, class Krylov, class WholeBody>
void add_mesh(DistributedArrays& arrays, const std::string& number, const MeshSets& sets, Body& body, Chunk& chunk,
              Krylov& krylov, const WholeBody& whole, const ListedLevel& listed, bool keeps_tangents) {
  const std::string of_body = "body" + number + ".", of_chunk = "chunk" + number + ".",
                    of_krylov = "krylov" + number + ".";
  arrays.add(of_body + "tets", sets.tet, body.tets.contents());
  arrays.add(of_body + "node_tet_ranges", sets.node, body.node_tet_ranges.contents());
  arrays.add(of_body + "rest", sets.node, body.rest.contents());
  arrays.add(of_body + "positions", sets.node, body.positions);
  arrays.add(of_body + "trial", sets.node, body.trial);
  arrays.add(of_body + "kept", sets.node, body.kept);
  arrays.add(of_body + "loads", sets.node, body.loads.contents());
  arrays.add(of_body + "motion", sets.node, body.motion.contents());
  arrays.add(of_body + "forces", sets.node, body.forces);
  arrays.add(of_body + "trial_forces", sets.node, body.trial_forces);
  arrays.add(of_body + "increment", sets.node, body.increment);
  arrays.add_window(of_chunk + "corners", sets.chunk_tet, chunk.corners, most_of_window<Chunk>());
  arrays.add_window(of_chunk + "tangent", sets.kept_tet, chunk.tangent, keeps_tangents ? 0 : most_of_window<Chunk>());
  arrays.add(of_krylov + "step", sets.node, krylov.step);
  arrays.add(of_krylov + "residual", sets.node, krylov.residual);
  arrays.add(of_krylov + "direction", sets.node, krylov.direction);
  arrays.add(of_krylov + "product", sets.node, krylov.product);
  arrays.connect(body.tets.contents(), "nodes", sets.node, nodes_of<4>(whole.tets, listed.tets, listed.nodes),
                 listed.tets.known);
  arrays.connect_rows(
      body.node_tet_ranges.contents(), of_body + "node_tet_entries", body.node_tet_entries.contents(), "code", sets.tet,
      rows_of(whole.node_tet_ranges, whole.node_tet_entries, listed.nodes, listed.tets, add_to_code<NodeTetEntry>),
      NodeTetEntry::bits, listed.nodes.known);
}
/// Adds and connects the tets of edges, from which tangents are assembled. @param whole of which `listed` is a part
template <class Body, class WholeBody>
void add_edge_tets(DistributedArrays& arrays, const std::string& number, const std::string& edge,
                   const std::string& kept_tet, Body& body, const WholeBody& whole, const ListedLevel& listed) {
  const std::string of_body = "body" + number + ".";
  arrays.add(of_body + "edge_tet_ranges", edge, body.edge_tet_ranges.contents());
  arrays.connect_rows(
      body.edge_tet_ranges.contents(), of_body + "edge_tet_entries", body.edge_tet_entries.contents(), "code", kept_tet,
      rows_of(whole.edge_tet_ranges, whole.edge_tet_entries, listed.edges, listed.tets, add_to_code<EdgeTetEntry>),
      EdgeTetEntry::bits, listed.edges.known);
}
/// Adds and connects the patches over which volumes are averaged, without the lists by which tangents are summed.
template <class Body, class Patches, class WholePatches>
void add_patches(DistributedArrays& arrays, const std::string& number, const MeshSets& sets, const std::string& patch,
                 Body& body, Patches& patches, const WholePatches& whole, const ListedLevel& listed) {
  const std::string of_patches = "patches" + number + ".";
  arrays.add("body" + number + ".volumes", patch, body.volumes);
  arrays.add(of_patches + "tet_patches", sets.tet, patches.tet_patches.contents());
  arrays.add(of_patches + "nodes", patch, patches.nodes.contents());
  arrays.add(of_patches + "patch_tet_ranges", patch, patches.patch_tet_ranges.contents());
  arrays.add(of_patches + "tangent", patch, patches.tangent);
  arrays.connect(patches.tet_patches.contents(), "patch", patch,
                 patch_of(whole.tet_patches, listed.tets, listed.patches), listed.tets.known);
  arrays.connect(patches.nodes.contents(), "nodes", sets.node, nodes_of<8>(whole.nodes, listed.patches, listed.nodes),
                 listed.patches.known);
  arrays.connect_rows(patches.patch_tet_ranges.contents(), of_patches + "patch_tet_entries",
                      patches.patch_tet_entries.contents(), "tet", sets.tet,
                      rows_of(whole.patch_tet_ranges, whole.patch_tet_entries, listed.patches, listed.tets,
                              [](auto& entry, Index number) { entry.tet += number; }),
                      0, listed.patches.known);
}
/// Adds and connects the patches of edges, where the stiffness is assembled.
template <class Patches, class WholePatches>
void add_edge_patches(DistributedArrays& arrays, const std::string& number, const std::string& edge,
                      const std::string& patch, Patches& patches, const WholePatches& whole,
                      const ListedLevel& listed) {
  const std::string of_patches = "patches" + number + ".";
  arrays.add(of_patches + "edge_patch_ranges", edge, patches.edge_patch_ranges.contents());
  arrays.connect_rows(patches.edge_patch_ranges.contents(), of_patches + "edge_patch_entries",
                      patches.edge_patch_entries.contents(), "code", patch,
                      rows_of(whole.edge_patch_ranges, whole.edge_patch_entries, listed.edges, listed.patches,
                              add_to_code<EdgePatchEntry>),
                      EdgePatchEntry::bits, listed.edges.known);
}
/// Adds and connects the patches of nodes, which gather from them where the stiffness is not assembled.
template <class Patches, class WholePatches>
void add_node_patches(DistributedArrays& arrays, const std::string& number, const std::string& node,
                      const std::string& patch, Patches& patches, const WholePatches& whole,
                      const ListedLevel& listed) {
  const std::string of_patches = "patches" + number + ".";
  arrays.add(of_patches + "changes", patch, patches.changes);
  arrays.add(of_patches + "node_patch_ranges", node, patches.node_patch_ranges.contents());
  arrays.connect_rows(patches.node_patch_ranges.contents(), of_patches + "node_patch_entries",
                      patches.node_patch_entries.contents(), "code", patch,
                      rows_of(whole.node_patch_ranges, whole.node_patch_entries, listed.nodes, listed.patches,
                              add_to_code<NodePatchEntry>),
                      NodePatchEntry::bits, listed.nodes.known);
}
/// Adds the arrays of a level of tangents that are not assembled.
template <class Level>
void add_level_by_tets(DistributedArrays& arrays, const std::string& number, const std::string& node, Level& level) {
  const std::string of_level = "level" + number + ".";
  arrays.add(of_level + "constraints", node, level.constraints.contents());
  arrays.add(of_level + "node_stiffness", node, level.node_stiffness);
  arrays.add(of_level + "scales", node, level.scales);
  arrays.add(of_level + "inverse", node, level.inverse);
  arrays.add(of_level + "residual", node, level.residual);
  arrays.add(of_level + "correction", node, level.correction);
}
/// Fills constraints and scales as the solver of one process does. @pre cut() was called
template <class Level>
void fill_level_by_tets(DistributedArrays& arrays, Level& level, const LevelGraph& graph, const ListedObjects& nodes) {
  arrays.fill(level.constraints.contents(), [&](index_t node) {
    typename std::remove_cvref_t<decltype(level.constraints)>::Value value{};
    value.fixed = graph.fixed[at(nodes.here(node))];
    return value;
  });
  arrays.fill(level.scales, [](index_t /*node*/) {  // which an unpreconditioned solve leaves
    typename std::remove_cvref_t<decltype(level.scales)>::Value value{};
    value.scale = value.inverse = 1;
    return value;
  });
}
/// Fills positions [m], loads [N] and motion [m] as the solver of one process does. @pre cut() was called
template <class Body, class Krylov, class WholeBody>
void fill_mesh(DistributedArrays& arrays, Body& body, Krylov& krylov, const WholeBody& whole,
               const ListedObjects& nodes) {
  const auto fill = [&](auto& array, const auto& from) {
    arrays.fill(array, [&, view = from.const_view()](index_t node) { return view.get(nodes.here(node)); });
  };
  fill(body.rest.contents(), whole.rest);
  for (auto* positions : {&body.positions, &body.trial, &body.kept}) fill(*positions, whole.rest);
  fill(body.loads.contents(), whole.loads);
  fill(body.motion.contents(), whole.motion);
  body.state.resize(1);
  copy(body.state, whole.state);
  krylov.state.resize(1);
}

/// What this rank has of a scene's groups of arrays.
/// @tparam Whole of the whole mesh, on the host: body, patches or NoArrays, chunk, levels, krylov, the graphs of the
/// levels, facts, and Choices
/// @tparam Part the same, without graphs, where this rank has them in other memory
template <class Whole, class Part = Whole>
struct PartOfEquilibrium {
  using Body = decltype(Part::body);
  using Patches = decltype(Part::patches);
  using Level = typename decltype(Part::levels)::value_type;
  using Choices = typename Whole::Choices;
  DistributedArrays arrays;
  Body body;
  Patches patches;
  decltype(Part::chunk) chunk;
  std::vector<Level> levels;
  decltype(Part::krylov) krylov;
  MeshFacts facts;
  std::vector<MaterialRange> materials;  ///< where there are several

  /// @param whole of the same mesh on each rank. Where its volumes are not averaged, patches have no objects
  /// @param cut the finest so many levels are cut
  /// @param add_more add_more(*this) adds further arrays @param behind_names as cut() takes it
  template <class AddMore>
  PartOfEquilibrium(const Ranks& ranks, HaloUses uses, const Whole& whole, std::size_t cut, const AddMore& add_more,
                    const std::function<void()>& behind_names = {})
      : arrays(ranks, uses), levels(whole.levels.size()) {
    const MeshSets sets{"node", "tet", "chunk_tet", "kept_tet"};
    const ListedLevel listed = listed_of(whole);
    add_sets(listed);
    if constexpr (Choices::assembled) {
      add_levels(arrays, each_level(), whole.graphs, cut, listed_levels_of(whole));
      arrays.same_set("node", "level[0].node");
    } else {
      add_level_by_tets(arrays, "", "node", levels.front());
    }
    add_mesh(arrays, "", sets, body, chunk, krylov, whole.body, listed, !Choices::assembled);
    if constexpr (Choices::assembled) add_edge_tets(arrays, "", "level[0].edge", "kept_tet", body, whole.body, listed);
    if constexpr (!std::is_same_v<Patches, NoArrays>) {
      if (whole.body.volumes.size() > 0) add_mesh_patches(sets, whole, listed);
    }
    add_more(*this);
    arrays.cut(behind_names);
    fill(whole, cut);
    note_facts(whole);
  }

 private:
  [[nodiscard]] std::vector<Level*> each_level() {
    std::vector<Level*> each;
    for (Level& level : levels) each.push_back(&level);
    return each;
  }
  /// Which objects of all the levels of `whole` have; none where they are whole.
  [[nodiscard]] static ListedLevels listed_levels_of(const Whole& whole) {
    if constexpr (requires { whole.listed; }) return whole.listed;
    return {};
  }
  [[nodiscard]] static ListedLevel listed_of(const Whole& whole) {
    if constexpr (requires { whole.listed; }) return whole.listed.levels.front();
    const auto& body = whole.body;
    return {{body.rest.size()}, {body.edge_tet_ranges.size()}, {body.tets.size()}, {body.volumes.size()}};
  }
  void add_sets(const ListedLevel& listed) {
    for (const char* set : {"node", "block_node"}) arrays.add_set(set, listed.nodes.size);
    for (const char* set : {"tet", "chunk_tet", "kept_tet"}) arrays.add_set(set, listed.tets.size);
    arrays.same_set("block_node", "node");
    for (const char* set : {"chunk_tet", "kept_tet"}) arrays.same_set(set, "tet");
    arrays.follow("tet", "node");
  }
  void add_mesh_patches(const MeshSets& sets, const Whole& whole, const ListedLevel& listed) {
    arrays.add_set("patch", listed.patches.size);
    arrays.follow("patch", "node");
    add_patches(arrays, "", sets, "patch", body, patches, whole.patches, listed);
    if constexpr (Choices::assembled) {
      add_edge_patches(arrays, "", "level[0].edge", "patch", patches, whole.patches, listed);
    } else {
      add_node_patches(arrays, "", "node", "patch", patches, whole.patches, listed);
    }
  }
  void fill(const Whole& whole, std::size_t cut) {
    fill_mesh(arrays, body, krylov, whole.body, listed_of(whole).nodes);
    if constexpr (Choices::assembled) {
      facts.sums = fill_levels(arrays, each_level(), whole.graphs, listed_levels_of(whole));
      facts.rows = rows_of_levels(each_level(), whole.graphs, cut);
    } else {
      fill_level_by_tets(arrays, levels.front(), whole.graphs.front(), listed_of(whole).nodes);
    }
  }
  void note_facts(const Whole& whole) {
    facts.meshes = whole.facts.meshes;
    facts.nodes = whole.facts.nodes;
    facts.node_stiffness = whole.facts.node_stiffness;
    facts.plane_stiffness = whole.facts.plane_stiffness;
    facts.rounding_force = whole.facts.rounding_force;
    facts.moves = whole.facts.moves;
    if constexpr (requires { whole.materials; }) materials = materials_of(arrays, body, whole.materials);
    facts.chunks =
        chunks_of_part<Choices::assembled>(arrays.transport(), body, levels.front().edges.contents(), materials);
  }
};

}  // namespace physgen::fem
