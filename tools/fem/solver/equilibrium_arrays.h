// The arrays of one mesh on which equilibrium is sought, by name: in double what decides the result, in Real the
// tangent.
#pragma once

#include <fem/solver/solver_arrays.h>

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
  IncidenceRows<Space> edge_patches;
  quasistatic::VolumePatchArray<double, Space> volumes;
  quasistatic::PatchTangentArray<Real, Space> tangent;

  PatchArrays(const MeshLevel& level, const EdgeParts& parts, bool injects)
      : tet_patches(moved_to<decltype(tet_patches)>(host_tet_patches(level.patches))),
        nodes(moved_to<decltype(nodes)>(host_nodes(level.patches))),
        patch_tets(host_patch_tets(level)),
        edge_patches(incidence_rows<IncidenceRows<Host>>(parts.edge_patches, index_t(level.patches.nodes.size()))),
        volumes(index_t(level.patches.nodes.size())),
        tangent(volumes.size()) {
    if (injects) parents = moved_to<decltype(parents)>(host_parents(level));
  }

  [[nodiscard]] index_t bytes() const {
    return bytes_of(tet_patches, nodes, parents, patch_tets.ranges(), patch_tets.entries(), edge_patches.ranges(),
                    edge_patches.entries(), volumes, tangent);
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

template <class Real_, class Space_>
struct EquilibriumArrays {
  using Real = Real_;
  using Space = Space_;

  elasticity::TetArray<Real, Space> tets;
  IncidenceRows<Space> node_tets, edge_tets;
  std::unique_ptr<PatchArrays<Real, Space>> patches;  ///< where volumes are averaged

  elasticity::NodePositionArray<double, Space> rest;
  elasticity::NodePositionArray<double, Space> positions;   ///< of the last equilibrium, or of the step under way
  elasticity::NodePositionArray<double, Space> trial;       ///< where a step leads
  elasticity::NodePositionArray<double, Space> kept;        ///< where the load increment began
  elasticity::NodeForceArray<double, Space> loads;          ///< external, at a load of 1
  elasticity::NodeDisplacementArray<double, Space> motion;  ///< of prescribed components, at a load of 1
  elasticity::NodeForceArray<double, Space> forces;  ///< elastic and external; in prescribed components -reaction
  elasticity::NodeForceArray<double, Space> trial_forces;
  elasticity::CornerForcesArray<double, Space> corners;
  quasistatic::TetTangentArray<Real, Space> tangent;
  elasticity::NodeDisplacementArray<double, Space> increment;  ///< of prescribed components
  quasistatic::EquilibriumArray<double, Space> state;
  double spacing = 0;  ///< the mean distance of neighbours at rest, or about that [m]

  /// @param injects whether equilibrium is solved on the next coarser mesh, too, whose pressures patches begin with
  EquilibriumArrays(const MeshLevel& level, const LevelGraph& graph, bool injects)
      : EquilibriumArrays(level, graph, injects, make_edge_parts(level, graph)) {}

  [[nodiscard]] index_t nodes() const { return rest.size(); }
  [[nodiscard]] index_t bytes() const {
    return bytes_of(tets, node_tets.ranges(), node_tets.entries(), edge_tets.ranges(), edge_tets.entries(), rest,
                    positions, trial, kept, loads, motion, forces, trial_forces, corners, tangent, increment, state) +
           (patches == nullptr ? 0 : patches->bytes());
  }
  [[nodiscard]] index_t tet_count() const { return tets.size(); }

 private:
  EquilibriumArrays(const MeshLevel& level, const LevelGraph& graph, bool injects, const EdgeParts& parts)
      : tets(moved_to<decltype(tets)>(host_tets(level))),
        node_tets(incidence_rows<IncidenceRows<Host>>(level.mesh.node_tets, index_t(level.mesh.tets.size()))),
        edge_tets(incidence_rows<IncidenceRows<Host>>(parts.edge_tets, index_t(level.mesh.tets.size()))),
        patches(level.patches.nodes.empty() ? nullptr
                                            : std::make_unique<PatchArrays<Real, Space>>(level, parts, injects)),
        rest(moved_to<decltype(rest)>(host_positions(level))),
        positions(moved_to<decltype(positions)>(rest)),
        trial(moved_to<decltype(trial)>(rest)),
        kept(moved_to<decltype(kept)>(rest)),
        loads(graph.nodes),
        motion(graph.nodes),
        forces(graph.nodes),
        trial_forces(graph.nodes),
        corners(tets.size()),
        tangent(tets.size()),
        increment(graph.nodes),
        state(1),
        spacing(mean_spacing(level.mesh, level.rest)) {}

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
