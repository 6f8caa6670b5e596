// What one of several ranks has of the arrays on which a scene seeks equilibrium, cut from those of the whole mesh,
// which are filled as the solver fills its own.
#pragma once

#include <physgen/distributed/executor.h>

#include <array>
#include <span>
#include <type_traits>
#include <vector>

#include "../solver/scene_groups.h"

namespace physgen::fem {

/// The entries of each row, by global numbers.
template <class Ranges, class Entries>
[[nodiscard]] auto rows_of(const Ranges& ranges, const Entries& entries) {
  return [ranges = ranges.const_view(), entries = entries.const_view()](index_t object) {
    std::vector<typename Entries::Value> row;
    const index_t begin = ranges[object].begin(), end = ranges[object].end();
    for (index_t k = begin; k < end; ++k) row.push_back(entries.get(k));
    return row;
  };
}
/// The nodes that an object names, by global numbers.
template <int kCount, class Array>
[[nodiscard]] auto nodes_of(const Array& array) {
  return [view = array.const_view()](index_t object) {
    std::array<Index, kCount> nodes{};
    for (int k = 0; k < kCount; ++k) nodes[static_cast<std::size_t>(k)] = view[object].nodes()[k];
    return nodes;
  };
}

/// The groups of arrays of SceneGroups, one level among them.
template <class Body, class Patches, class Chunk, class Level, class Krylov, class Choices>
struct PartOfEquilibrium {
  using Whole = SceneGroups<Body, Patches, Chunk, Level, Krylov, Choices>;
  DistributedArrays arrays;
  Body body;
  Patches patches;
  Chunk chunk;
  std::vector<Level> levels = std::vector<Level>(1);
  Krylov krylov;
  MeshFacts facts;

  /// @param whole of the same mesh on each rank
  /// @param add_more add_more(arrays) adds further arrays
  template <class AddMore>
  PartOfEquilibrium(const Ranks& ranks, HaloUses uses, const Whole& whole, const AddMore& add_more)
      : arrays(ranks, uses) {
    add_sets(whole);
    add_body(whole);
    add_linear();
    if constexpr (!std::is_same_v<Patches, NoArrays>) add_patches(whole);
    if constexpr (Choices::assembled) add_edges(whole);
    add_more(arrays);
    arrays.cut();
    fill(whole);
    note_facts(whole);
  }

 private:
  void add_sets(const Whole& whole) {
    for (const char* set : {"node", "block_node"}) arrays.add_set(set, whole.body.rest.size());
    for (const char* set : {"tet", "chunk_tet", "kept_tet"}) arrays.add_set(set, whole.body.tets.size());
    arrays.same_set("block_node", "node");
    for (const char* set : {"chunk_tet", "kept_tet"}) arrays.same_set(set, "tet");
    arrays.follow("tet", "node");
  }
  void add_body(const Whole& whole) {
    arrays.add("body.tets", "tet", body.tets.contents());
    arrays.add("body.node_tet_ranges", "node", body.node_tet_ranges.contents());
    arrays.add("body.rest", "node", body.rest.contents());
    arrays.add("body.positions", "node", body.positions);
    arrays.add("body.trial", "node", body.trial);
    arrays.add("body.kept", "node", body.kept);
    arrays.add("body.loads", "node", body.loads.contents());
    arrays.add("body.motion", "node", body.motion.contents());
    arrays.add("body.forces", "node", body.forces);
    arrays.add("body.trial_forces", "node", body.trial_forces);
    arrays.add("body.increment", "node", body.increment);
    arrays.add("chunk.corners", "chunk_tet", chunk.corners);
    arrays.add("chunk.tangent", "kept_tet", chunk.tangent);
    const auto& all = whole.body;
    arrays.connect(body.tets.contents(), "nodes", "node", nodes_of<4>(all.tets));
    arrays.connect_rows(body.node_tet_ranges.contents(), "body.node_tet_entries", body.node_tet_entries.contents(),
                        "code", "tet", rows_of(all.node_tet_ranges, all.node_tet_entries), NodeTetEntry::bits);
  }
  void add_linear() {
    Level& level = levels.front();
    arrays.add("level.constraints", "node", level.constraints.contents());
    arrays.add("level.node_stiffness", "block_node", level.node_stiffness);
    arrays.add("level.scales", "node", level.scales);
    arrays.add("level.inverse", "block_node", level.inverse);
    arrays.add("level.residual", "node", level.residual);
    arrays.add("level.correction", "node", level.correction);
    arrays.add("krylov.step", "node", krylov.step);
    arrays.add("krylov.residual", "node", krylov.residual);
    arrays.add("krylov.direction", "node", krylov.direction);
    arrays.add("krylov.product", "node", krylov.product);
  }
  void add_patches(const Whole& whole) {
    const auto& all = whole.patches;
    for (const char* set : {"patch", "volume"}) arrays.add_set(set, whole.body.volumes.size());
    arrays.same_set("volume", "patch");
    arrays.follow("patch", "node");
    arrays.add("body.volumes", "volume", body.volumes);
    arrays.add("patches.tet_patches", "tet", patches.tet_patches.contents());
    arrays.add("patches.nodes", "patch", patches.nodes.contents());
    arrays.add("patches.patch_tet_ranges", "patch", patches.patch_tet_ranges.contents());
    arrays.add("patches.tangent", "patch", patches.tangent);
    arrays.connect(
        patches.tet_patches.contents(), "patch", "volume",
        [view = all.tet_patches.const_view()](index_t tet) { return std::array<Index, 1>{view[tet].patch()}; });
    arrays.connect(patches.nodes.contents(), "nodes", "node", nodes_of<8>(all.nodes));
    arrays.connect_rows(patches.patch_tet_ranges.contents(), "patches.patch_tet_entries",
                        patches.patch_tet_entries.contents(), "tet", "tet",
                        rows_of(all.patch_tet_ranges, all.patch_tet_entries));
    if constexpr (!Choices::assembled) add_node_patches(whole);
  }
  /// Where nodes gather from patches.
  void add_node_patches(const Whole& whole) {
    const auto& all = whole.patches;
    arrays.add_set("change", whole.body.volumes.size());
    arrays.same_set("change", "patch");
    arrays.add("patches.changes", "change", patches.changes);
    arrays.add("patches.node_patch_ranges", "node", patches.node_patch_ranges.contents());
    arrays.connect_rows(patches.node_patch_ranges.contents(), "patches.node_patch_entries",
                        patches.node_patch_entries.contents(), "code", "patch",
                        rows_of(all.node_patch_ranges, all.node_patch_entries), NodePatchEntry::bits);
  }
  /// What assembled tangents have besides.
  void add_edges(const Whole& whole) {
    Level& level = levels.front();
    const auto& system = whole.levels.front();
    arrays.add_set("edge_node", whole.body.rest.size());
    arrays.same_set("edge_node", "node");
    arrays.add_set("edge", system.edges.size());
    arrays.follow("edge", "node");
    arrays.add("body.edge_tet_ranges", "edge", body.edge_tet_ranges.contents());
    arrays.add("level.edges", "edge", level.edges.contents());
    arrays.add("level.node_edge_ranges", "edge_node", level.node_edge_ranges.contents());
    arrays.add("level.edge_stiffness", "edge", level.edge_stiffness);
    arrays.add("level.scaled_nodes", "edge_node", level.scaled_nodes);
    arrays.connect(level.edges.contents(), "nodes", "node", nodes_of<2>(system.edges));
    arrays.connect_rows(body.edge_tet_ranges.contents(), "body.edge_tet_entries", body.edge_tet_entries.contents(),
                        "code", "kept_tet", rows_of(whole.body.edge_tet_ranges, whole.body.edge_tet_entries),
                        EdgeTetEntry::bits);
    arrays.connect_rows(level.node_edge_ranges.contents(), "level.node_edge_entries",
                        level.node_edge_entries.contents(), "code", "edge",
                        rows_of(system.node_edge_ranges, system.node_edge_entries), NodeEdgeEntry::bits);
    if constexpr (!std::is_same_v<Patches, NoArrays>) add_edge_patches(whole.patches);
  }
  void add_edge_patches(const Patches& all) {
    arrays.add("patches.edge_patch_ranges", "edge", patches.edge_patch_ranges.contents());
    arrays.connect_rows(patches.edge_patch_ranges.contents(), "patches.edge_patch_entries",
                        patches.edge_patch_entries.contents(), "code", "patch",
                        rows_of(all.edge_patch_ranges, all.edge_patch_entries), EdgePatchEntry::bits);
  }
  void fill(const Whole& whole) {
    const auto& all = whole.body;
    arrays.fill(body.rest.contents(), all.rest);
    for (auto* positions : {&body.positions, &body.trial, &body.kept}) arrays.fill(*positions, all.rest);
    arrays.fill(body.loads.contents(), all.loads);
    arrays.fill(body.motion.contents(), all.motion);
    arrays.fill(levels.front().constraints.contents(), whole.levels.front().constraints);
    body.state = all.state;
    krylov.state.resize(1);
  }
  /// One chunk for all tets that are here, and lists of the edges that are here.
  void note_facts(const Whole& whole) {
    const index_t nodes = body.rest.size(), edges = levels.front().edges.size();
    facts.nodes = whole.facts.nodes;
    facts.node_stiffness = whole.facts.node_stiffness;
    facts.plane_stiffness = whole.facts.plane_stiffness;
    facts.rounding_force = whole.facts.rounding_force;
    facts.moves = whole.facts.moves;
    facts.chunks = {{0, body.tets.size(), 0, nodes, 0, edges}};
    if constexpr (Choices::assembled) note_sums(arrays.set("edge"));
  }
  void note_sums(const LocalSet& edges) {
    std::vector<std::array<Index, 2>> ends(static_cast<std::size_t>(edges.size()));
    const auto ends_of = nodes_of<2>(levels.front().edges);
    for (index_t e = edges.first(); e < edges.last(); ++e) ends[static_cast<std::size_t>(e)] = ends_of(e);
    const bool has_edges = edges.first() < edges.last();
    facts.sums.emplace_back(static_cast<Index>(body.rest.size()), ends, SpaceKind::host, sizeof(float), SumOrder::fixed,
                            has_edges ? edges.first() : edges.size());
  }
};

}  // namespace physgen::fem
