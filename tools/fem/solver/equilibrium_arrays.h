// The arrays of one mesh on which equilibrium is sought, by name: in double what decides the result, in Real the
// tangent.
#pragma once

#include <fem/solver/ring_arrays.h>
#include <fem/solver/solver_arrays.h>
#include <fem/solver/tet_chunks.h>

#include <memory>

namespace physgen::fem {

template <class Space>
using PatchTetRows = RowArrays<elasticity::IncidenceRangeArray<float, Space>, quasistatic::PatchTetArray<float, Space>>;

/// Those of volumes averaged over patches.
template <class Real, class Space>
struct PatchArrays {
  quasistatic::TetPatchArray<Real, Space> tet_patches;
  quasistatic::PatchNodesArray<Real, Space> nodes;
  quasistatic::PatchParentArray<Real, Space> parents;  ///< where there is a coarser level
  PatchTetRows<Space> patch_tets;
  PackedRows<Space> edge_patches, node_patches;  ///< as TangentLists says, the other without rows
  quasistatic::PatchTangentArray<Real, Space> tangent;
  quasistatic::PatchChangeArray<Real, Space> changes;  ///< on the CPU, of products without blocks of edges

  PatchArrays(const MeshLevel& level, const EdgeParts& parts, bool injects, TangentLists lists)
      : tet_patches(moved_to<decltype(tet_patches)>(host_tet_patches(level.patches))),
        nodes(moved_to<decltype(nodes)>(host_nodes(level.patches))),
        patch_tets(host_patch_tets(level)),
        tangent(index_t(level.patches.nodes.size())) {
    if (injects) parents = moved_to<decltype(parents)>(host_parents(level));
    const index_t patches = tangent.size();
    if (lists == TangentLists::of_edges) {
      edge_patches = PackedRows<Space>(packed_rows<EdgePatchEntry>(parts.edge_patches, patches, "patches"));
    } else if (lists == TangentLists::of_nodes) {
      node_patches = PackedRows<Space>(packed_rows<NodePatchEntry>(make_node_patches(level), patches, "patches"));
      if constexpr (Space::kind == SpaceKind::host) changes = decltype(changes)(patches);
    }
  }

  [[nodiscard]] index_t bytes() const {
    return bytes_of(tet_patches, nodes, parents, patch_tets.ranges(), patch_tets.entries(), edge_patches.ranges(),
                    edge_patches.entries(), node_patches.ranges(), node_patches.entries(), tangent, changes);
  }

 private:
  static auto host_tet_patches(const VolumePatches& patches) {
    quasistatic::TetPatchArray<Real> array(index_t(patches.tet_patch.size()));
    for (index_t t = 0; t < array.size(); ++t) array.view()[t].patch() = patches.tet_patch[std::size_t(t)];
    return array;
  }
  static auto host_nodes(const VolumePatches& patches) {
    quasistatic::PatchNodesArray<Real> array(index_t(patches.nodes.size()));
    for (index_t p = 0; p < array.size(); ++p) {
      for (int k = 0; k < 8; ++k) array.view()[p].nodes()[k] = patches.nodes[std::size_t(p)][std::size_t(k)];
    }
    return array;
  }
  static auto host_parents(const MeshLevel& level) {
    quasistatic::PatchParentArray<Real> array(index_t(level.patch_parents.size()));
    for (index_t p = 0; p < array.size(); ++p) array.view()[p].patch() = level.patch_parents[std::size_t(p)];
    return array;
  }
  static auto host_patch_tets(const MeshLevel& level) {
    const IncidenceList& list = level.patches.patch_tets;
    std::vector<typename quasistatic::PatchTetArray<float>::Value> entries;
    for (const auto& entry : list.entries) {
      const auto& slots = level.patches.tet_slots[std::size_t(entry.element)];
      entries.push_back({entry.element, slots[0] | slots[1] << 3 | slots[2] << 6 | slots[3] << 9});
    }
    return PatchTetRows<Host>::from_offsets({"tet", index_t(level.mesh.tets.size())}, list.first, entries);
  }
};

/// What kernels over a chunk of tets leave for the next: arrays that meshes of one solver share, since one is evaluated
/// at a time.
template <class Real, class Space>
struct ChunkArrays {
  elasticity::CornerForcesArray<double, Space> corners;
  quasistatic::TetTangentArray<Real, Space> tangent;

  /// @param tets in the largest chunk
  /// @param tangents how many are kept: of a chunk, or of all tets
  ChunkArrays(index_t tets, index_t tangents) : corners(tets), tangent(tangents) {}
  [[nodiscard]] index_t bytes() const { return bytes_of(corners, tangent); }
};

template <class Real_, class Space_>
struct EquilibriumArrays {
  using Real = Real_;
  using Space = Space_;

  elasticity::TetArray<Real, Space> tets;
  PackedRows<Space> node_tets, edge_tets;  ///< of edges where TangentLists are
  std::vector<TetChunk> chunks;
  std::unique_ptr<PatchArrays<Real, Space>> patches;       ///< where volumes are averaged over them
  std::unique_ptr<RingArrays<Real, Space>> rings;          ///< where volumes are averaged at nodes
  quasistatic::MeanVolumeArray<double, Space> volumes;     ///< per patch or node; none where they are those of tets
  std::shared_ptr<ChunkArrays<Real, Space>> chunk_arrays;  ///< not in bytes()

  elasticity::NodePositionArray<double, Space> rest;
  elasticity::NodePositionArray<double, Space> positions;   ///< of the last equilibrium, or of the step under way
  elasticity::NodePositionArray<double, Space> trial;       ///< where a step leads
  elasticity::NodePositionArray<double, Space> kept;        ///< where the load increment began
  elasticity::NodeForceArray<double, Space> loads;          ///< external, at a load of 1
  elasticity::NodeDisplacementArray<double, Space> motion;  ///< of prescribed components, at a load of 1
  elasticity::NodeForceArray<double, Space> forces;  ///< elastic and external; in prescribed components -reaction
  elasticity::NodeForceArray<double, Space> trial_forces;
  elasticity::NodeDisplacementArray<double, Space> increment;  ///< of prescribed components
  quasistatic::EquilibriumArray<double, Space> state;
  double spacing = 0;  ///< the mean distance of neighbours at rest, or about that [m]

  /// @param injects whether equilibrium is solved on the next coarser mesh, too, whose pressures patches begin with
  /// @param lists where they are not of edges, the tangents of all tets are kept
  /// @param shared arrays of another mesh, which has as many tets at least; or none
  EquilibriumArrays(const MeshLevel& level, const LevelGraph& graph, bool injects, TangentLists lists,
                    const std::shared_ptr<ChunkArrays<Real, Space>>& shared)
      : EquilibriumArrays(level, graph, injects, lists, shared,
                          lists == TangentLists::of_edges ? make_edge_parts(level, graph) : EdgeParts{}) {}

  [[nodiscard]] index_t nodes() const { return rest.size(); }
  [[nodiscard]] index_t bytes() const {
    return bytes_of(tets, node_tets.ranges(), node_tets.entries(), edge_tets.ranges(), edge_tets.entries(), rest,
                    positions, trial, kept, loads, motion, forces, trial_forces, increment, state, volumes) +
           (patches == nullptr ? 0 : patches->bytes()) + (rings == nullptr ? 0 : rings->bytes());
  }
  [[nodiscard]] index_t tet_count() const { return tets.size(); }
  /// As one chunk. @pre the tangents of all tets are kept
  [[nodiscard]] TetChunk all_tets() const { return {0, tet_count(), 0, nodes(), 0, 0}; }

 private:
  EquilibriumArrays(const MeshLevel& level, const LevelGraph& graph, bool injects, TangentLists lists,
                    const std::shared_ptr<ChunkArrays<Real, Space>>& shared, const EdgeParts& parts)
      : tets(moved_to<decltype(tets)>(host_tets(level))),
        node_tets(packed_rows<NodeTetEntry>(level.mesh.node_tets, index_t(level.mesh.tets.size()), "tets")),
        chunks(make_tet_chunks(level.mesh, graph.edges, most_chunk_tets(Space::kind))),
        patches(level.patches.nodes.empty() ? nullptr
                                            : std::make_unique<PatchArrays<Real, Space>>(level, parts, injects, lists)),
        rings(level.averages_at_nodes ? std::make_unique<RingArrays<Real, Space>>(level.mesh) : nullptr),
        volumes(level.averages_at_nodes ? index_t{graph.nodes} : index_t(level.patches.nodes.size())),
        chunk_arrays(shared != nullptr ? shared
                                       : std::make_shared<ChunkArrays<Real, Space>>(
                                             chunks.front().tets(),
                                             lists == TangentLists::of_edges ? chunks.front().tets() : tets.size())),
        rest(moved_to<decltype(rest)>(host_positions(level))),
        positions(moved_to<decltype(positions)>(rest)),
        trial(moved_to<decltype(trial)>(rest)),
        kept(moved_to<decltype(kept)>(rest)),
        loads(graph.nodes),
        motion(graph.nodes),
        forces(graph.nodes),
        trial_forces(graph.nodes),
        increment(graph.nodes),
        state(1),
        spacing(mean_spacing(level.mesh, level.rest)) {
    if (lists != TangentLists::of_edges) return;
    edge_tets = PackedRows<Space>(packed_rows<EdgeTetEntry>(parts.edge_tets, tets.size(), "tets"));
  }

  static auto host_tets(const MeshLevel& level) {
    elasticity::TetArray<Real> array(index_t(level.mesh.tets.size()));
    store_tets(level.mesh, array.view());
    return array;
  }
  static auto host_positions(const MeshLevel& level) {
    elasticity::NodePositionArray<double> array(level.mesh.nodes);
    store_positions(level.rest, array.view());
    return array;
  }
};

}  // namespace physgen::fem
