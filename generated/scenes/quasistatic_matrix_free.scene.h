// Arrays of the scene quasistatic_matrix_free, with the fields that its program needs. Written by physgen from
// scenes/quasistatic_matrix_free.h and the kernels that it runs: change these, not this file.
#pragma once

#include <physgen/scenes/scene_arrays.h>

#include <elasticity.physgen.h>
#include <quasistatic.physgen.h>

namespace scenes { struct quasistatic_matrix_free; }

/// Equilibrium of a stable Neo-Hookean body: Newton's method, and conjugate gradients with products from the tangents
/// of tets and patches, preconditioned by the nodes' blocks. Volumes are averaged over patches of tets.
namespace scenes::quasistatic_matrix_free_scene {

namespace tags::body {
struct tets { static constexpr const char* name = "body.tets"; };
struct node_tet_ranges { static constexpr const char* name = "body.node_tet_ranges"; };
struct node_tet_entries { static constexpr const char* name = "body.node_tet_entries"; };
struct edge_tet_ranges { static constexpr const char* name = "body.edge_tet_ranges"; struct begin; struct end; };
struct edge_tet_entries { static constexpr const char* name = "body.edge_tet_entries"; struct code; };
struct volumes { static constexpr const char* name = "body.volumes"; };
struct rest { static constexpr const char* name = "body.rest"; };
struct positions { static constexpr const char* name = "body.positions"; };
struct trial { static constexpr const char* name = "body.trial"; };
struct kept { static constexpr const char* name = "body.kept"; };
struct loads { static constexpr const char* name = "body.loads"; };
struct motion { static constexpr const char* name = "body.motion"; };
struct forces { static constexpr const char* name = "body.forces"; };
struct trial_forces { static constexpr const char* name = "body.trial_forces"; };
struct increment { static constexpr const char* name = "body.increment"; };
struct state { static constexpr const char* name = "body.state"; };
}  // namespace tags::body

/// How elasticity::IncidenceRange is stored in body.edge_tet_ranges. Not stored:
/// - begin, end: it is an input; nothing reads it
template <class Stored>
struct BodyEdge_tet_rangesFormats : Stored {
  using begin = physgen::format::Pruned<quasistatic_matrix_free, tags::body::edge_tet_ranges,
      tags::body::edge_tet_ranges::begin>;
  using end = physgen::format::Pruned<quasistatic_matrix_free, tags::body::edge_tet_ranges,
      tags::body::edge_tet_ranges::end>;
};

/// How quasistatic::PackedIncidence is stored in body.edge_tet_entries. Not stored:
/// - code: it is an input; nothing reads it
template <class Stored>
struct BodyEdge_tet_entriesFormats : Stored {
  using code = physgen::format::Pruned<quasistatic_matrix_free, tags::body::edge_tet_entries,
      tags::body::edge_tet_entries::code>;
};

template <class Space_ = physgen::Host, class Real_ = float, class Stored_ = physgen::StoredAsDeclared>
struct Body {
  using Space = Space_;
  using Real = Real_;
  using Stored = Stored_;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t tet = 0;
    physgen::index_t node = 0;
    physgen::index_t corner = 0;
    physgen::index_t edge = 0;
    physgen::index_t tet_edge = 0;
    physgen::index_t volume = 0;
  };

  /// elasticity::Tet, per tet: nodes
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::tets, ::elasticity::TetArray<Real, Space>>> tets;
  /// The tets of each node: rows of NodeTetEntry.
  /// elasticity::IncidenceRange, per node: begin, end
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::node_tet_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>> node_tet_ranges;
  /// quasistatic::PackedIncidence, per corner: code
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::node_tet_entries,
      ::quasistatic::PackedIncidenceArray<float, Space>>> node_tet_entries;
  /// The tets of each edge: rows of EdgeTetEntry. None where the stiffness is not assembled.
  /// elasticity::IncidenceRange, per edge: left out, takes stores
  physgen::ReadOnlyArray<physgen::PrunedArray<physgen::StoredArray<Stored, tags::body::edge_tet_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>, BodyEdge_tet_rangesFormats>> edge_tet_ranges;
  /// quasistatic::PackedIncidence, per tet_edge: left out, takes stores
  physgen::ReadOnlyArray<physgen::PrunedArray<physgen::StoredArray<Stored, tags::body::edge_tet_entries,
      ::quasistatic::PackedIncidenceArray<float, Space>>, BodyEdge_tet_entriesFormats>> edge_tet_entries;
  /// The volumes of each patch or node where volumes are averaged.
  /// quasistatic::MeanVolume, per volume: volume, ratio, pressure, linearised, tangent_pressure, before, full
  physgen::StoredArray<Stored, tags::body::volumes, ::quasistatic::MeanVolumeArray<double, Space>> volumes;
  /// elasticity::NodePosition, per node: x
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::rest, ::elasticity::NodePositionArray<double,
      Space>>> rest;
  /// Positions of the last equilibrium, or of the step under way.
  /// elasticity::NodePosition, per node: x
  physgen::StoredArray<Stored, tags::body::positions, ::elasticity::NodePositionArray<double, Space>> positions;
  /// Where a step leads.
  /// elasticity::NodePosition, per node: x
  physgen::StoredArray<Stored, tags::body::trial, ::elasticity::NodePositionArray<double, Space>> trial;
  /// Where the load increment began.
  /// elasticity::NodePosition, per node: x
  physgen::StoredArray<Stored, tags::body::kept, ::elasticity::NodePositionArray<double, Space>> kept;
  /// External, at a load of 1.
  /// elasticity::NodeForce, per node: f
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::loads, ::elasticity::NodeForceArray<double,
      Space>>> loads;
  /// The motion of prescribed components, at a load of 1.
  /// elasticity::NodeDisplacement, per node: dx
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::motion, ::elasticity::NodeDisplacementArray<double,
      Space>>> motion;
  /// Elastic and external; in prescribed components minus the reaction.
  /// elasticity::NodeForce, per node: f
  physgen::StoredArray<Stored, tags::body::forces, ::elasticity::NodeForceArray<double, Space>> forces;
  /// elasticity::NodeForce, per node: f
  physgen::StoredArray<Stored, tags::body::trial_forces, ::elasticity::NodeForceArray<double, Space>> trial_forces;
  /// The increment of prescribed components.
  /// elasticity::NodeDisplacement, per node: dx
  physgen::StoredArray<Stored, tags::body::increment, ::elasticity::NodeDisplacementArray<double, Space>> increment;
  /// Its volumetric energy is 0 where no volumes are averaged.
  /// quasistatic::Equilibrium, 1 object: elastic, volumetric, loads, free_square, fixed_square, work, smallest_ratio
  physgen::StoredArray<Stored, tags::body::state, ::quasistatic::EquilibriumArray<double, Space>> state;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(tets, counts.tet);
    physgen::allocate(node_tet_ranges, counts.node);
    physgen::allocate(node_tet_entries, counts.corner);
    physgen::allocate(edge_tet_ranges, counts.edge);
    physgen::allocate(edge_tet_entries, counts.tet_edge);
    physgen::allocate(volumes, counts.volume, {"volume", "ratio", "pressure", "linearised", "tangent_pressure",
        "before", "full"});
    physgen::allocate(rest, counts.node);
    physgen::allocate(positions, counts.node);
    physgen::allocate(trial, counts.node, {"x"});
    physgen::allocate(kept, counts.node);
    physgen::allocate(loads, counts.node);
    physgen::allocate(motion, counts.node);
    physgen::allocate(forces, counts.node, {"f"});
    physgen::allocate(trial_forces, counts.node, {"f"});
    physgen::allocate(increment, counts.node, {"dx"});
    physgen::allocate(state, 1, {"elastic", "loads", "free_square", "fixed_square", "work", "smallest_ratio"});
  }

  /// Bytes of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return tets.bytes() + node_tet_ranges.bytes() + node_tet_entries.bytes() + edge_tet_ranges.bytes() +
           edge_tet_entries.bytes() + volumes.bytes() + rest.bytes() + positions.bytes() + trial.bytes() +
           kept.bytes() + loads.bytes() + motion.bytes() + forces.bytes() + trial_forces.bytes() + increment.bytes() +
           state.bytes();
  }
  /// The same of arrays of so many objects, without making them. @pre no count is negative
  [[nodiscard]] static constexpr physgen::index_t bytes(const Counts& counts) {
    return physgen::bytes_of_array<decltype(tets)>(counts.tet) +
           physgen::bytes_of_array<decltype(node_tet_ranges)>(counts.node) +
           physgen::bytes_of_array<decltype(node_tet_entries)>(counts.corner) +
           physgen::bytes_of_array<decltype(edge_tet_ranges)>(counts.edge) +
           physgen::bytes_of_array<decltype(edge_tet_entries)>(counts.tet_edge) +
           physgen::bytes_of_array<decltype(volumes)>(counts.volume) +
           physgen::bytes_of_array<decltype(rest)>(counts.node) +
           physgen::bytes_of_array<decltype(positions)>(counts.node) +
           physgen::bytes_of_array<decltype(trial)>(counts.node) +
           physgen::bytes_of_array<decltype(kept)>(counts.node) +
           physgen::bytes_of_array<decltype(loads)>(counts.node) +
           physgen::bytes_of_array<decltype(motion)>(counts.node) +
           physgen::bytes_of_array<decltype(forces)>(counts.node) +
           physgen::bytes_of_array<decltype(trial_forces)>(counts.node) +
           physgen::bytes_of_array<decltype(increment)>(counts.node) + physgen::bytes_of_array<decltype(state)>(1);
  }
};

namespace tags::patches {
struct tet_patches { static constexpr const char* name = "patches.tet_patches"; };
struct nodes { static constexpr const char* name = "patches.nodes"; };
struct parents { static constexpr const char* name = "patches.parents"; };
struct patch_tet_ranges { static constexpr const char* name = "patches.patch_tet_ranges"; };
struct patch_tet_entries { static constexpr const char* name = "patches.patch_tet_entries"; };
struct edge_patch_ranges { static constexpr const char* name = "patches.edge_patch_ranges"; struct begin; struct end; };
struct edge_patch_entries { static constexpr const char* name = "patches.edge_patch_entries"; struct code; };
struct node_patch_ranges { static constexpr const char* name = "patches.node_patch_ranges"; };
struct node_patch_entries { static constexpr const char* name = "patches.node_patch_entries"; };
struct tangent { static constexpr const char* name = "patches.tangent"; };
struct changes { static constexpr const char* name = "patches.changes"; };
}  // namespace tags::patches

/// How elasticity::IncidenceRange is stored in patches.edge_patch_ranges. Not stored:
/// - begin, end: it is an input; nothing reads it
template <class Stored>
struct PatchesEdge_patch_rangesFormats : Stored {
  using begin = physgen::format::Pruned<quasistatic_matrix_free, tags::patches::edge_patch_ranges,
      tags::patches::edge_patch_ranges::begin>;
  using end = physgen::format::Pruned<quasistatic_matrix_free, tags::patches::edge_patch_ranges,
      tags::patches::edge_patch_ranges::end>;
};

/// How quasistatic::PackedIncidence is stored in patches.edge_patch_entries. Not stored:
/// - code: it is an input; nothing reads it
template <class Stored>
struct PatchesEdge_patch_entriesFormats : Stored {
  using code = physgen::format::Pruned<quasistatic_matrix_free, tags::patches::edge_patch_entries,
      tags::patches::edge_patch_entries::code>;
};

template <class Space_ = physgen::Host, class Real_ = float, class Stored_ = physgen::StoredAsDeclared>
struct Patches {
  using Space = Space_;
  using Real = Real_;
  using Stored = Stored_;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t tet = 0;
    physgen::index_t patch = 0;
    physgen::index_t child = 0;
    physgen::index_t edge = 0;
    physgen::index_t edge_patch = 0;
    physgen::index_t node = 0;
    physgen::index_t node_patch = 0;
    physgen::index_t change = 0;
  };

  /// quasistatic::TetPatch, per tet: patch
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::patches::tet_patches, ::quasistatic::TetPatchArray<Real,
      Space>>> tet_patches;
  /// quasistatic::PatchNodes, per patch: nodes
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::patches::nodes, ::quasistatic::PatchNodesArray<Real,
      Space>>> nodes;
  /// Where there is a coarser level.
  /// quasistatic::PatchParent, per child: patch
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::patches::parents, ::quasistatic::PatchParentArray<Real,
      Space>>> parents;
  /// elasticity::IncidenceRange, per patch: begin, end
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::patches::patch_tet_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>> patch_tet_ranges;
  /// quasistatic::PatchTet, per tet: tet, slots
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::patches::patch_tet_entries,
      ::quasistatic::PatchTetArray<float, Space>>> patch_tet_entries;
  /// Rows of EdgePatchEntry, where the stiffness is assembled.
  /// elasticity::IncidenceRange, per edge: left out, takes stores
  physgen::ReadOnlyArray<physgen::PrunedArray<physgen::StoredArray<Stored, tags::patches::edge_patch_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>, PatchesEdge_patch_rangesFormats>> edge_patch_ranges;
  /// quasistatic::PackedIncidence, per edge_patch: left out, takes stores
  physgen::ReadOnlyArray<physgen::PrunedArray<physgen::StoredArray<Stored, tags::patches::edge_patch_entries,
      ::quasistatic::PackedIncidenceArray<float, Space>>, PatchesEdge_patch_entriesFormats>> edge_patch_entries;
  /// Rows of NodePatchEntry, where it is not.
  /// elasticity::IncidenceRange, per node: begin, end
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::patches::node_patch_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>> node_patch_ranges;
  /// quasistatic::PackedIncidence, per node_patch: code
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::patches::node_patch_entries,
      ::quasistatic::PackedIncidenceArray<float, Space>>> node_patch_entries;
  /// quasistatic::PatchTangent, per patch: g, k
  physgen::StoredArray<Stored, tags::patches::tangent, ::quasistatic::PatchTangentArray<Real, Space>> tangent;
  /// The changes in products without blocks of edges, on the CPU.
  /// quasistatic::PatchChange, per change: change
  physgen::StoredArray<Stored, tags::patches::changes, ::quasistatic::PatchChangeArray<Real, Space>> changes;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(tet_patches, counts.tet);
    physgen::allocate(nodes, counts.patch);
    physgen::allocate(parents, counts.child);
    physgen::allocate(patch_tet_ranges, counts.patch);
    physgen::allocate(patch_tet_entries, counts.tet);
    physgen::allocate(edge_patch_ranges, counts.edge);
    physgen::allocate(edge_patch_entries, counts.edge_patch);
    physgen::allocate(node_patch_ranges, counts.node);
    physgen::allocate(node_patch_entries, counts.node_patch);
    physgen::allocate(tangent, counts.patch, {"g", "k"});
    physgen::allocate(changes, counts.change, {"change"});
  }

  /// Bytes of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return tet_patches.bytes() + nodes.bytes() + parents.bytes() + patch_tet_ranges.bytes() +
           patch_tet_entries.bytes() + edge_patch_ranges.bytes() + edge_patch_entries.bytes() +
           node_patch_ranges.bytes() + node_patch_entries.bytes() + tangent.bytes() + changes.bytes();
  }
  /// The same of arrays of so many objects, without making them. @pre no count is negative
  [[nodiscard]] static constexpr physgen::index_t bytes(const Counts& counts) {
    return physgen::bytes_of_array<decltype(tet_patches)>(counts.tet) +
           physgen::bytes_of_array<decltype(nodes)>(counts.patch) +
           physgen::bytes_of_array<decltype(parents)>(counts.child) +
           physgen::bytes_of_array<decltype(patch_tet_ranges)>(counts.patch) +
           physgen::bytes_of_array<decltype(patch_tet_entries)>(counts.tet) +
           physgen::bytes_of_array<decltype(edge_patch_ranges)>(counts.edge) +
           physgen::bytes_of_array<decltype(edge_patch_entries)>(counts.edge_patch) +
           physgen::bytes_of_array<decltype(node_patch_ranges)>(counts.node) +
           physgen::bytes_of_array<decltype(node_patch_entries)>(counts.node_patch) +
           physgen::bytes_of_array<decltype(tangent)>(counts.patch) +
           physgen::bytes_of_array<decltype(changes)>(counts.change);
  }
};

namespace tags::chunk {
struct corners { static constexpr const char* name = "chunk.corners"; };
struct tangent { static constexpr const char* name = "chunk.tangent"; };
}  // namespace tags::chunk

template <class Space_ = physgen::Host, class Real_ = float, class Stored_ = physgen::StoredAsDeclared>
struct Chunk {
  using Space = Space_;
  using Real = Real_;
  using Stored = Stored_;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t chunk_tet = 0;
    physgen::index_t kept_tet = 0;
  };

  /// elasticity::CornerForces, per chunk_tet: G
  physgen::StoredArray<Stored, tags::chunk::corners, ::elasticity::CornerForcesArray<double, Space>> corners;
  /// The tangent of a chunk, or of all tets.
  /// quasistatic::TetTangent, per kept_tet: U, g, x1111, x2211, x3311, x2222, x3322, x3333, x2121, x2112, x3131, x3113,
  /// x3232, x3223
  physgen::StoredArray<Stored, tags::chunk::tangent, ::quasistatic::TetTangentArray<Real, Space>> tangent;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(corners, counts.chunk_tet, {"G"});
    physgen::allocate(tangent, counts.kept_tet, {"U", "g", "x1111", "x2211", "x3311", "x2222", "x3322", "x3333",
        "x2121", "x2112", "x3131", "x3113", "x3232", "x3223"});
  }

  /// Bytes of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return corners.bytes() + tangent.bytes();
  }
  /// The same of arrays of so many objects, without making them. @pre no count is negative
  [[nodiscard]] static constexpr physgen::index_t bytes(const Counts& counts) {
    return physgen::bytes_of_array<decltype(corners)>(counts.chunk_tet) +
           physgen::bytes_of_array<decltype(tangent)>(counts.kept_tet);
  }
};

namespace tags::level {
struct constraints { static constexpr const char* name = "level.constraints"; };
struct edges { static constexpr const char* name = "level.edges"; struct nodes; };
struct node_edge_ranges { static constexpr const char* name = "level.node_edge_ranges"; struct begin; struct end; };
struct node_edge_entries { static constexpr const char* name = "level.node_edge_entries"; struct code; };
struct node_stiffness { static constexpr const char* name = "level.node_stiffness"; };
struct edge_stiffness { static constexpr const char* name = "level.edge_stiffness"; struct E; };
struct scales { static constexpr const char* name = "level.scales"; struct inverse; };
struct scaled_nodes { static constexpr const char* name = "level.scaled_nodes"; struct K; };
struct scaled_edges { static constexpr const char* name = "level.scaled_edges"; struct E; };
struct inverse { static constexpr const char* name = "level.inverse"; };
struct smoother { static constexpr const char* name = "level.smoother"; struct largest; struct length; };
struct residual { static constexpr const char* name = "level.residual"; };
struct correction { static constexpr const char* name = "level.correction"; };
struct direction { static constexpr const char* name = "level.direction"; struct dx; };
struct power { static constexpr const char* name = "level.power"; struct dx; };
struct parents { static constexpr const char* name = "level.parents"; };
struct grid_parents { static constexpr const char* name = "level.grid_parents"; struct nodes; struct weights; };
struct child_ranges { static constexpr const char* name = "level.child_ranges"; struct begin; struct end; };
struct child_entries { static constexpr const char* name = "level.child_entries"; struct code; };
struct edge_term_ranges { static constexpr const char* name = "level.edge_term_ranges"; struct begin; struct end; };
struct edge_term_entries { static constexpr const char* name = "level.edge_term_entries"; struct code; };
struct translations { static constexpr const char* name = "level.translations"; struct T; };
struct coarse_inverse { static constexpr const char* name = "level.coarse_inverse"; struct G; };
}  // namespace tags::level

/// How elasticity::Edge is stored in level.edges. Not stored:
/// - nodes: it is an input; nothing reads it
template <class Stored>
struct LevelEdgesFormats : Stored {
  using nodes = physgen::format::Pruned<quasistatic_matrix_free, tags::level::edges, tags::level::edges::nodes>;
};

/// How elasticity::IncidenceRange is stored in level.node_edge_ranges. Not stored:
/// - begin, end: it is an input; nothing reads it
template <class Stored>
struct LevelNode_edge_rangesFormats : Stored {
  using begin = physgen::format::Pruned<quasistatic_matrix_free, tags::level::node_edge_ranges,
      tags::level::node_edge_ranges::begin>;
  using end = physgen::format::Pruned<quasistatic_matrix_free, tags::level::node_edge_ranges,
      tags::level::node_edge_ranges::end>;
};

/// How quasistatic::PackedIncidence is stored in level.node_edge_entries. Not stored:
/// - code: it is an input; nothing reads it
template <class Stored>
struct LevelNode_edge_entriesFormats : Stored {
  using code = physgen::format::Pruned<quasistatic_matrix_free, tags::level::node_edge_entries,
      tags::level::node_edge_entries::code>;
};

/// How elasticity::EdgeStiffness is stored in level.edge_stiffness. Not stored:
/// - E: nothing uses it
template <class Stored>
struct LevelEdge_stiffnessFormats : Stored {
  using E = physgen::format::Pruned<quasistatic_matrix_free, tags::level::edge_stiffness,
      tags::level::edge_stiffness::E>;
};

/// How quasistatic::NodeScale is stored in level.scales. Not stored:
/// - inverse: it is an input; written by physgen::fem::ComputeNodeScale(level.node_stiffness, level.scales); nothing
/// reads it
template <class Stored>
struct LevelScalesFormats : Stored {
  using inverse = physgen::format::Pruned<quasistatic_matrix_free, tags::level::scales, tags::level::scales::inverse>;
};

/// How elasticity::NodeStiffness is stored in level.scaled_nodes. Not stored:
/// - K: nothing uses it
template <class Stored>
struct LevelScaled_nodesFormats : Stored {
  using K = physgen::format::Pruned<quasistatic_matrix_free, tags::level::scaled_nodes, tags::level::scaled_nodes::K>;
};

/// How elasticity::EdgeStiffness is stored in level.scaled_edges. Not stored:
/// - E: nothing uses it
template <class Stored>
struct LevelScaled_edgesFormats : Stored {
  using E = physgen::format::Pruned<quasistatic_matrix_free, tags::level::scaled_edges, tags::level::scaled_edges::E>;
};

/// How quasistatic::Smoother is stored in level.smoother. Not stored:
/// - largest, length: nothing uses it
template <class Stored>
struct LevelSmootherFormats : Stored {
  using largest = physgen::format::Pruned<quasistatic_matrix_free, tags::level::smoother,
      tags::level::smoother::largest>;
  using length = physgen::format::Pruned<quasistatic_matrix_free, tags::level::smoother, tags::level::smoother::length>;
};

/// How elasticity::NodeDisplacement is stored in level.direction. Not stored:
/// - dx: nothing uses it
template <class Stored>
struct LevelDirectionFormats : Stored {
  using dx = physgen::format::Pruned<quasistatic_matrix_free, tags::level::direction, tags::level::direction::dx>;
};

/// How elasticity::NodeDisplacement is stored in level.power. Not stored:
/// - dx: nothing uses it
template <class Stored>
struct LevelPowerFormats : Stored {
  using dx = physgen::format::Pruned<quasistatic_matrix_free, tags::level::power, tags::level::power::dx>;
};

/// How quasistatic::GridParents is stored in level.grid_parents. Not stored:
/// - nodes, weights: it is an input; nothing reads it
template <class Stored>
struct LevelGrid_parentsFormats : Stored {
  using nodes = physgen::format::Pruned<quasistatic_matrix_free, tags::level::grid_parents,
      tags::level::grid_parents::nodes>;
  using weights = physgen::format::Pruned<quasistatic_matrix_free, tags::level::grid_parents,
      tags::level::grid_parents::weights>;
};

/// How elasticity::IncidenceRange is stored in level.child_ranges. Not stored:
/// - begin, end: it is an input; nothing reads it
template <class Stored>
struct LevelChild_rangesFormats : Stored {
  using begin = physgen::format::Pruned<quasistatic_matrix_free, tags::level::child_ranges,
      tags::level::child_ranges::begin>;
  using end = physgen::format::Pruned<quasistatic_matrix_free, tags::level::child_ranges,
      tags::level::child_ranges::end>;
};

/// How quasistatic::PackedIncidence is stored in level.child_entries. Not stored:
/// - code: it is an input; nothing reads it
template <class Stored>
struct LevelChild_entriesFormats : Stored {
  using code = physgen::format::Pruned<quasistatic_matrix_free, tags::level::child_entries,
      tags::level::child_entries::code>;
};

/// How elasticity::IncidenceRange is stored in level.edge_term_ranges. Not stored:
/// - begin, end: it is an input; nothing reads it
template <class Stored>
struct LevelEdge_term_rangesFormats : Stored {
  using begin = physgen::format::Pruned<quasistatic_matrix_free, tags::level::edge_term_ranges,
      tags::level::edge_term_ranges::begin>;
  using end = physgen::format::Pruned<quasistatic_matrix_free, tags::level::edge_term_ranges,
      tags::level::edge_term_ranges::end>;
};

/// How quasistatic::PackedIncidence is stored in level.edge_term_entries. Not stored:
/// - code: it is an input; nothing reads it
template <class Stored>
struct LevelEdge_term_entriesFormats : Stored {
  using code = physgen::format::Pruned<quasistatic_matrix_free, tags::level::edge_term_entries,
      tags::level::edge_term_entries::code>;
};

/// How quasistatic::TranslationStiffness is stored in level.translations. Not stored:
/// - T: nothing uses it
template <class Stored>
struct LevelTranslationsFormats : Stored {
  using T = physgen::format::Pruned<quasistatic_matrix_free, tags::level::translations, tags::level::translations::T>;
};

/// How quasistatic::CoarseInverse is stored in level.coarse_inverse. Not stored:
/// - G: nothing uses it
template <class Stored>
struct LevelCoarse_inverseFormats : Stored {
  using G = physgen::format::Pruned<quasistatic_matrix_free, tags::level::coarse_inverse,
      tags::level::coarse_inverse::G>;
};

template <class Space_ = physgen::Host, class Real_ = float, class Stored_ = physgen::StoredAsDeclared>
struct Level {
  using Space = Space_;
  using Real = Real_;
  using Stored = Stored_;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t node = 0;
    physgen::index_t edge = 0;
    physgen::index_t edge_node = 0;
    physgen::index_t edge_end = 0;
    physgen::index_t block_node = 0;
    physgen::index_t smoother = 0;
    physgen::index_t child = 0;
    physgen::index_t grid_child = 0;
    physgen::index_t parent = 0;
    physgen::index_t child_entry = 0;
    physgen::index_t coarse_edge = 0;
    physgen::index_t edge_term = 0;
    physgen::index_t grid_node = 0;
    physgen::index_t coarse_pair = 0;
  };

  /// quasistatic::NodeConstraint, per node: fixed
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::level::constraints, ::quasistatic::NodeConstraintArray<Real,
      Space>>> constraints;
  /// elasticity::Edge, per edge: left out, takes stores
  physgen::ReadOnlyArray<physgen::PrunedArray<physgen::StoredArray<Stored, tags::level::edges,
      ::elasticity::EdgeArray<Real, Space>>, LevelEdgesFormats>> edges;
  /// Rows of NodeEdgeEntry.
  /// elasticity::IncidenceRange, per edge_node: left out, takes stores
  physgen::ReadOnlyArray<physgen::PrunedArray<physgen::StoredArray<Stored, tags::level::node_edge_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>, LevelNode_edge_rangesFormats>> node_edge_ranges;
  /// quasistatic::PackedIncidence, per edge_end: left out, takes stores
  physgen::ReadOnlyArray<physgen::PrunedArray<physgen::StoredArray<Stored, tags::level::node_edge_entries,
      ::quasistatic::PackedIncidenceArray<float, Space>>, LevelNode_edge_entriesFormats>> node_edge_entries;
  /// elasticity::NodeStiffness, per block_node: K
  physgen::StoredArray<Stored, tags::level::node_stiffness, ::elasticity::NodeStiffnessArray<Real,
      Space>> node_stiffness;
  /// elasticity::EdgeStiffness, per edge: left out, takes stores
  physgen::PrunedArray<physgen::StoredArray<Stored, tags::level::edge_stiffness, ::elasticity::EdgeStiffnessArray<Real,
      Space>>, LevelEdge_stiffnessFormats> edge_stiffness;
  /// quasistatic::NodeScale, per node: scale; without inverse
  physgen::PrunedArray<physgen::StoredArray<Stored, tags::level::scales, ::quasistatic::NodeScaleArray<Real, Space>>,
      LevelScalesFormats> scales;
  /// elasticity::NodeStiffness, per edge_node: left out, takes stores
  physgen::PrunedArray<physgen::StoredArray<Stored, tags::level::scaled_nodes, ::elasticity::NodeStiffnessArray<Real,
      Space>>, LevelScaled_nodesFormats> scaled_nodes;
  /// elasticity::EdgeStiffness, per edge: left out, takes stores
  physgen::PrunedArray<physgen::StoredArray<Stored, tags::level::scaled_edges, ::elasticity::EdgeStiffnessArray<Real,
      Space>>, LevelScaled_edgesFormats> scaled_edges;
  /// quasistatic::NodeInverse, per block_node: D
  physgen::StoredArray<Stored, tags::level::inverse, ::quasistatic::NodeInverseArray<Real, Space>> inverse;
  /// quasistatic::Smoother, per smoother: left out, takes stores
  physgen::PrunedArray<physgen::StoredArray<Stored, tags::level::smoother, ::quasistatic::SmootherArray<double, Space>>,
      LevelSmootherFormats> smoother;
  /// r
  /// elasticity::NodeForceDifferential, per node: df
  physgen::StoredArray<Stored, tags::level::residual, ::elasticity::NodeForceDifferentialArray<Real, Space>> residual;
  /// z
  /// elasticity::NodeDisplacement, per node: dx
  physgen::StoredArray<Stored, tags::level::correction, ::elasticity::NodeDisplacementArray<Real, Space>> correction;
  /// d
  /// elasticity::NodeDisplacement, per edge_node: left out, takes stores
  physgen::PrunedArray<physgen::StoredArray<Stored, tags::level::direction, ::elasticity::NodeDisplacementArray<Real,
      Space>>, LevelDirectionFormats> direction;
  /// The eigenvector that power iterations approach.
  /// elasticity::NodeDisplacement, per edge_node: left out, takes stores
  physgen::PrunedArray<physgen::StoredArray<Stored, tags::level::power, ::elasticity::NodeDisplacementArray<Real,
      Space>>, LevelPowerFormats> power;
  /// quasistatic::NodeParents, per child: nodes
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::level::parents, ::quasistatic::NodeParentsArray<Real,
      Space>>> parents;
  /// In place of `parents`, to a background grid.
  /// quasistatic::GridParents, per grid_child: left out, takes stores
  physgen::ReadOnlyArray<physgen::PrunedArray<physgen::StoredArray<Stored, tags::level::grid_parents,
      ::quasistatic::GridParentsArray<Real, Space>>, LevelGrid_parentsFormats>> grid_parents;
  /// The children of each node of the coarser level: rows of ChildEntry.
  /// elasticity::IncidenceRange, per parent: left out, takes stores
  physgen::ReadOnlyArray<physgen::PrunedArray<physgen::StoredArray<Stored, tags::level::child_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>, LevelChild_rangesFormats>> child_ranges;
  /// quasistatic::PackedIncidence, per child_entry: left out, takes stores
  physgen::ReadOnlyArray<physgen::PrunedArray<physgen::StoredArray<Stored, tags::level::child_entries,
      ::quasistatic::PackedIncidenceArray<float, Space>>, LevelChild_entriesFormats>> child_entries;
  /// The terms of each edge of the coarser level: rows of EdgeTermEntry.
  /// elasticity::IncidenceRange, per coarse_edge: left out, takes stores
  physgen::ReadOnlyArray<physgen::PrunedArray<physgen::StoredArray<Stored, tags::level::edge_term_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>, LevelEdge_term_rangesFormats>> edge_term_ranges;
  /// quasistatic::PackedIncidence, per edge_term: left out, takes stores
  physgen::ReadOnlyArray<physgen::PrunedArray<physgen::StoredArray<Stored, tags::level::edge_term_entries,
      ::quasistatic::PackedIncidenceArray<float, Space>>, LevelEdge_term_entriesFormats>> edge_term_entries;
  /// The levels of a background grid, and the mesh on it, have these.
  /// quasistatic::TranslationStiffness, per grid_node: left out, takes stores
  physgen::PrunedArray<physgen::StoredArray<Stored, tags::level::translations,
      ::quasistatic::TranslationStiffnessArray<Real, Space>>, LevelTranslationsFormats> translations;
  /// The coarsest level alone has it.
  /// quasistatic::CoarseInverse, per coarse_pair: left out, takes stores
  physgen::PrunedArray<physgen::StoredArray<Stored, tags::level::coarse_inverse, ::quasistatic::CoarseInverseArray<Real,
      Space>>, LevelCoarse_inverseFormats> coarse_inverse;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(constraints, counts.node);
    physgen::allocate(edges, counts.edge);
    physgen::allocate(node_edge_ranges, counts.edge_node);
    physgen::allocate(node_edge_entries, counts.edge_end);
    physgen::allocate(node_stiffness, counts.block_node, {"K"});
    physgen::allocate(edge_stiffness, counts.edge);
    physgen::allocate(scales, counts.node);
    physgen::allocate(scaled_nodes, counts.edge_node);
    physgen::allocate(scaled_edges, counts.edge);
    physgen::allocate(inverse, counts.block_node, {"D"});
    physgen::allocate(smoother, counts.smoother);
    physgen::allocate(residual, counts.node, {"df"});
    physgen::allocate(correction, counts.node, {"dx"});
    physgen::allocate(direction, counts.edge_node);
    physgen::allocate(power, counts.edge_node);
    physgen::allocate(parents, counts.child);
    physgen::allocate(grid_parents, counts.grid_child);
    physgen::allocate(child_ranges, counts.parent);
    physgen::allocate(child_entries, counts.child_entry);
    physgen::allocate(edge_term_ranges, counts.coarse_edge);
    physgen::allocate(edge_term_entries, counts.edge_term);
    physgen::allocate(translations, counts.grid_node);
    physgen::allocate(coarse_inverse, counts.coarse_pair);
  }

  /// Bytes of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return constraints.bytes() + edges.bytes() + node_edge_ranges.bytes() + node_edge_entries.bytes() +
           node_stiffness.bytes() + edge_stiffness.bytes() + scales.bytes() + scaled_nodes.bytes() +
           scaled_edges.bytes() + inverse.bytes() + smoother.bytes() + residual.bytes() + correction.bytes() +
           direction.bytes() + power.bytes() + parents.bytes() + grid_parents.bytes() + child_ranges.bytes() +
           child_entries.bytes() + edge_term_ranges.bytes() + edge_term_entries.bytes() + translations.bytes() +
           coarse_inverse.bytes();
  }
  /// The same of arrays of so many objects, without making them. @pre no count is negative
  [[nodiscard]] static constexpr physgen::index_t bytes(const Counts& counts) {
    return physgen::bytes_of_array<decltype(constraints)>(counts.node) +
           physgen::bytes_of_array<decltype(edges)>(counts.edge) +
           physgen::bytes_of_array<decltype(node_edge_ranges)>(counts.edge_node) +
           physgen::bytes_of_array<decltype(node_edge_entries)>(counts.edge_end) +
           physgen::bytes_of_array<decltype(node_stiffness)>(counts.block_node) +
           physgen::bytes_of_array<decltype(edge_stiffness)>(counts.edge) +
           physgen::bytes_of_array<decltype(scales)>(counts.node) +
           physgen::bytes_of_array<decltype(scaled_nodes)>(counts.edge_node) +
           physgen::bytes_of_array<decltype(scaled_edges)>(counts.edge) +
           physgen::bytes_of_array<decltype(inverse)>(counts.block_node) +
           physgen::bytes_of_array<decltype(smoother)>(counts.smoother) +
           physgen::bytes_of_array<decltype(residual)>(counts.node) +
           physgen::bytes_of_array<decltype(correction)>(counts.node) +
           physgen::bytes_of_array<decltype(direction)>(counts.edge_node) +
           physgen::bytes_of_array<decltype(power)>(counts.edge_node) +
           physgen::bytes_of_array<decltype(parents)>(counts.child) +
           physgen::bytes_of_array<decltype(grid_parents)>(counts.grid_child) +
           physgen::bytes_of_array<decltype(child_ranges)>(counts.parent) +
           physgen::bytes_of_array<decltype(child_entries)>(counts.child_entry) +
           physgen::bytes_of_array<decltype(edge_term_ranges)>(counts.coarse_edge) +
           physgen::bytes_of_array<decltype(edge_term_entries)>(counts.edge_term) +
           physgen::bytes_of_array<decltype(translations)>(counts.grid_node) +
           physgen::bytes_of_array<decltype(coarse_inverse)>(counts.coarse_pair);
  }
};

namespace tags::krylov {
struct step { static constexpr const char* name = "krylov.step"; };
struct residual { static constexpr const char* name = "krylov.residual"; };
struct direction { static constexpr const char* name = "krylov.direction"; };
struct product { static constexpr const char* name = "krylov.product"; };
struct state { static constexpr const char* name = "krylov.state"; };
}  // namespace tags::krylov

template <class Space_ = physgen::Host, class Real_ = float, class Stored_ = physgen::StoredAsDeclared>
struct Krylov {
  using Space = Space_;
  using Real = Real_;
  using Stored = Stored_;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t node = 0;
  };

  /// dx
  /// elasticity::NodeDisplacement, per node: dx
  physgen::StoredArray<Stored, tags::krylov::step, ::elasticity::NodeDisplacementArray<Real, Space>> step;
  /// r = f + K dx
  /// elasticity::NodeForceDifferential, per node: df
  physgen::StoredArray<Stored, tags::krylov::residual, ::elasticity::NodeForceDifferentialArray<Real, Space>> residual;
  /// p
  /// elasticity::NodeDisplacement, per node: dx
  physgen::StoredArray<Stored, tags::krylov::direction, ::elasticity::NodeDisplacementArray<Real, Space>> direction;
  /// K p
  /// elasticity::NodeForceDifferential, per node: df
  physgen::StoredArray<Stored, tags::krylov::product, ::elasticity::NodeForceDifferentialArray<Real, Space>> product;
  /// quasistatic::LinearSolve, 1 object: rz, rz_first, tolerance, alpha, beta, iterations, status
  physgen::StoredArray<Stored, tags::krylov::state, ::quasistatic::LinearSolveArray<double, Space>> state;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(step, counts.node, {"dx"});
    physgen::allocate(residual, counts.node, {"df"});
    physgen::allocate(direction, counts.node, {"dx"});
    physgen::allocate(product, counts.node, {"df"});
    physgen::allocate(state, 1, {"rz", "rz_first", "tolerance", "alpha", "beta", "iterations", "status"});
  }

  /// Bytes of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return step.bytes() + residual.bytes() + direction.bytes() + product.bytes() + state.bytes();
  }
  /// The same of arrays of so many objects, without making them. @pre no count is negative
  [[nodiscard]] static constexpr physgen::index_t bytes(const Counts& counts) {
    return physgen::bytes_of_array<decltype(step)>(counts.node) +
           physgen::bytes_of_array<decltype(residual)>(counts.node) +
           physgen::bytes_of_array<decltype(direction)>(counts.node) +
           physgen::bytes_of_array<decltype(product)>(counts.node) + physgen::bytes_of_array<decltype(state)>(1);
  }
};

namespace tags::stresses {
struct of_tets { static constexpr const char* name = "stresses.of_tets"; };
}  // namespace tags::stresses

template <class Space_ = physgen::Host, class Real_ = float, class Stored_ = physgen::StoredAsDeclared>
struct Stresses {
  using Space = Space_;
  using Real = Real_;
  using Stored = Stored_;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t tet = 0;
  };

  /// elasticity::Stress, per tet: P
  physgen::StoredArray<Stored, tags::stresses::of_tets, ::elasticity::StressArray<double, Space>> of_tets;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(of_tets, counts.tet, {"P"});
  }

  /// Bytes of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return of_tets.bytes();
  }
  /// The same of arrays of so many objects, without making them. @pre no count is negative
  [[nodiscard]] static constexpr physgen::index_t bytes(const Counts& counts) {
    return physgen::bytes_of_array<decltype(of_tets)>(counts.tet);
  }
};

}  // namespace scenes::quasistatic_matrix_free_scene
