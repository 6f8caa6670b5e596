// What one of several ranks has of the arrays on which the scene quasistatic seeks equilibrium, cut from those of the
// whole mesh, which are filled as the solver fills its own.
#pragma once

#include <physgen/distributed/executor.h>
#include <quasistatic.scene.h>
#include <scenes/quasistatic.h>

#include <array>
#include <span>
#include <vector>

#include "../solver/scene_groups.h"

namespace physgen::fem {

namespace of_scene = scenes::quasistatic_scene;

/// Those of the whole mesh, without averaged volumes.
using WholeEquilibrium =
    SceneGroups<of_scene::Body<>, NoArrays, of_scene::Chunk<>, of_scene::Level<>, of_scene::Krylov<>>;

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

struct PartOfEquilibrium {
  DistributedArrays arrays;
  of_scene::Body<> body;
  NoArrays patches;
  of_scene::Chunk<> chunk;
  std::vector<of_scene::Level<>> levels = std::vector<of_scene::Level<>>(1);
  of_scene::Krylov<> krylov;
  MeshFacts facts;

  /// @param whole of the same mesh on each rank
  PartOfEquilibrium(const Ranks& ranks, HaloUses uses, const WholeEquilibrium& whole) : arrays(ranks, uses) {
    add_sets(whole);
    add_body();
    add_linear();
    connect(whole);
    arrays.cut();
    fill(whole);
    note_facts(whole);
  }

 private:
  void add_sets(const WholeEquilibrium& whole) {
    for (const char* set : {"node", "edge_node", "block_node"}) arrays.add_set(set, whole.body.rest.size());
    for (const char* set : {"tet", "chunk_tet", "kept_tet"}) arrays.add_set(set, whole.body.tets.size());
    arrays.add_set("edge", whole.levels.front().edges.size());
    for (const char* set : {"edge_node", "block_node"}) arrays.same_set(set, "node");
    for (const char* set : {"chunk_tet", "kept_tet"}) arrays.same_set(set, "tet");
    arrays.follow("tet", "node");
    arrays.follow("edge", "node");
  }
  void add_body() {
    arrays.add("body.tets", "tet", body.tets.contents());
    arrays.add("body.node_tet_ranges", "node", body.node_tet_ranges.contents());
    arrays.add("body.edge_tet_ranges", "edge", body.edge_tet_ranges.contents());
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
  }
  void add_linear() {
    of_scene::Level<>& level = levels.front();
    arrays.add("level.constraints", "node", level.constraints.contents());
    arrays.add("level.edges", "edge", level.edges.contents());
    arrays.add("level.node_edge_ranges", "edge_node", level.node_edge_ranges.contents());
    arrays.add("level.node_stiffness", "block_node", level.node_stiffness);
    arrays.add("level.edge_stiffness", "edge", level.edge_stiffness);
    arrays.add("level.scales", "node", level.scales);
    arrays.add("level.scaled_nodes", "edge_node", level.scaled_nodes);
    arrays.add("level.inverse", "block_node", level.inverse);
    arrays.add("level.residual", "node", level.residual);
    arrays.add("level.correction", "node", level.correction);
    arrays.add("krylov.step", "node", krylov.step);
    arrays.add("krylov.residual", "node", krylov.residual);
    arrays.add("krylov.direction", "node", krylov.direction);
    arrays.add("krylov.product", "node", krylov.product);
  }
  void connect(const WholeEquilibrium& whole) {
    const auto& all = whole.body;
    const auto& system = whole.levels.front();
    of_scene::Level<>& level = levels.front();
    arrays.connect(body.tets.contents(), "nodes", "node", nodes_of<4>(all.tets));
    arrays.connect(level.edges.contents(), "nodes", "node", nodes_of<2>(system.edges));
    arrays.connect_rows(body.node_tet_ranges.contents(), "body.node_tet_entries", body.node_tet_entries.contents(),
                        "code", "tet", rows_of(all.node_tet_ranges, all.node_tet_entries), NodeTetEntry::bits);
    arrays.connect_rows(body.edge_tet_ranges.contents(), "body.edge_tet_entries", body.edge_tet_entries.contents(),
                        "code", "kept_tet", rows_of(all.edge_tet_ranges, all.edge_tet_entries), EdgeTetEntry::bits);
    arrays.connect_rows(level.node_edge_ranges.contents(), "level.node_edge_entries",
                        level.node_edge_entries.contents(), "code", "edge",
                        rows_of(system.node_edge_ranges, system.node_edge_entries), NodeEdgeEntry::bits);
  }
  void fill(const WholeEquilibrium& whole) {
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
  void note_facts(const WholeEquilibrium& whole) {
    const index_t nodes = body.rest.size();
    const LocalSet& edges = arrays.set("edge");
    facts.rounding_force = whole.facts.rounding_force;
    facts.moves = whole.facts.moves;
    facts.chunks = {{0, body.tets.size(), 0, nodes, 0, edges.size()}};
    std::vector<std::array<Index, 2>> ends(static_cast<std::size_t>(edges.size()));
    const auto ends_of = nodes_of<2>(levels.front().edges);
    for (index_t e = edges.first(); e < edges.last(); ++e) ends[static_cast<std::size_t>(e)] = ends_of(e);
    const bool has_edges = edges.first() < edges.last();
    facts.sums.emplace_back(static_cast<Index>(nodes), ends, SpaceKind::host, sizeof(float), SumOrder::fixed,
                            has_edges ? edges.first() : edges.size());
  }
};

}  // namespace physgen::fem
