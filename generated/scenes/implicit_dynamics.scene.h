// Arrays of the scene implicit_dynamics, with the fields that its program needs. Written by physgen from
// scenes/implicit_dynamics.h and the kernels that it runs: change these, not this file.
#pragma once

#include <physgen/scenes/scene_arrays.h>

#include <dynamics.physgen.h>
#include <elasticity.physgen.h>
#include <quasistatic.physgen.h>

namespace scenes { struct implicit_dynamics; }

/// Motion of a stable Neo-Hookean body: one step of backward Euler with lumped mass and damping, whose equilibrium is
/// found as that of the scene quasistatic. Volumes are averaged over patches of tets.
namespace scenes::implicit_dynamics_scene {

namespace tags::body {
struct tets { static constexpr const char* name = "body.tets"; };
struct node_tet_ranges { static constexpr const char* name = "body.node_tet_ranges"; };
struct node_tet_entries { static constexpr const char* name = "body.node_tet_entries"; };
struct edge_tet_ranges { static constexpr const char* name = "body.edge_tet_ranges"; };
struct edge_tet_entries { static constexpr const char* name = "body.edge_tet_entries"; };
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
  /// elasticity::IncidenceRange, per edge: begin, end
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::edge_tet_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>> edge_tet_ranges;
  /// quasistatic::PackedIncidence, per tet_edge: code
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::edge_tet_entries,
      ::quasistatic::PackedIncidenceArray<float, Space>>> edge_tet_entries;
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
struct parents { static constexpr const char* name = "patches.parents"; struct patch; };
struct patch_tet_ranges { static constexpr const char* name = "patches.patch_tet_ranges"; };
struct patch_tet_entries { static constexpr const char* name = "patches.patch_tet_entries"; };
struct edge_patch_ranges { static constexpr const char* name = "patches.edge_patch_ranges"; };
struct edge_patch_entries { static constexpr const char* name = "patches.edge_patch_entries"; };
struct node_patch_ranges { static constexpr const char* name = "patches.node_patch_ranges"; struct begin; struct end; };
struct node_patch_entries { static constexpr const char* name = "patches.node_patch_entries"; struct code; };
struct tangent { static constexpr const char* name = "patches.tangent"; };
struct changes { static constexpr const char* name = "patches.changes"; struct change; };
}  // namespace tags::patches

/// How quasistatic::PatchParent is stored in patches.parents. Not stored:
/// - patch: it is an input; nothing reads it
template <class Stored>
struct PatchesParentsFormats : Stored {
  using patch = physgen::format::Pruned<implicit_dynamics, tags::patches::parents, tags::patches::parents::patch>;
};

/// How elasticity::IncidenceRange is stored in patches.node_patch_ranges. Not stored:
/// - begin, end: it is an input; nothing reads it
template <class Stored>
struct PatchesNode_patch_rangesFormats : Stored {
  using begin = physgen::format::Pruned<implicit_dynamics, tags::patches::node_patch_ranges,
      tags::patches::node_patch_ranges::begin>;
  using end = physgen::format::Pruned<implicit_dynamics, tags::patches::node_patch_ranges,
      tags::patches::node_patch_ranges::end>;
};

/// How quasistatic::PackedIncidence is stored in patches.node_patch_entries. Not stored:
/// - code: it is an input; nothing reads it
template <class Stored>
struct PatchesNode_patch_entriesFormats : Stored {
  using code = physgen::format::Pruned<implicit_dynamics, tags::patches::node_patch_entries,
      tags::patches::node_patch_entries::code>;
};

/// How quasistatic::PatchChange is stored in patches.changes. Not stored:
/// - change: nothing uses it
template <class Stored>
struct PatchesChangesFormats : Stored {
  using change = physgen::format::Pruned<implicit_dynamics, tags::patches::changes, tags::patches::changes::change>;
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
  /// quasistatic::PatchParent, per child: left out, takes stores
  physgen::ReadOnlyArray<physgen::PrunedArray<physgen::StoredArray<Stored, tags::patches::parents,
      ::quasistatic::PatchParentArray<Real, Space>>, PatchesParentsFormats>> parents;
  /// elasticity::IncidenceRange, per patch: begin, end
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::patches::patch_tet_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>> patch_tet_ranges;
  /// quasistatic::PatchTet, per tet: tet, slots
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::patches::patch_tet_entries,
      ::quasistatic::PatchTetArray<float, Space>>> patch_tet_entries;
  /// Rows of EdgePatchEntry, where the stiffness is assembled.
  /// elasticity::IncidenceRange, per edge: begin, end
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::patches::edge_patch_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>> edge_patch_ranges;
  /// quasistatic::PackedIncidence, per edge_patch: code
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::patches::edge_patch_entries,
      ::quasistatic::PackedIncidenceArray<float, Space>>> edge_patch_entries;
  /// Rows of NodePatchEntry, where it is not.
  /// elasticity::IncidenceRange, per node: left out, takes stores
  physgen::ReadOnlyArray<physgen::PrunedArray<physgen::StoredArray<Stored, tags::patches::node_patch_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>, PatchesNode_patch_rangesFormats>> node_patch_ranges;
  /// quasistatic::PackedIncidence, per node_patch: left out, takes stores
  physgen::ReadOnlyArray<physgen::PrunedArray<physgen::StoredArray<Stored, tags::patches::node_patch_entries,
      ::quasistatic::PackedIncidenceArray<float, Space>>, PatchesNode_patch_entriesFormats>> node_patch_entries;
  /// quasistatic::PatchTangent, per patch: g, k
  physgen::StoredArray<Stored, tags::patches::tangent, ::quasistatic::PatchTangentArray<Real, Space>> tangent;
  /// The changes in products without blocks of edges, on the CPU.
  /// quasistatic::PatchChange, per change: left out, takes stores
  physgen::PrunedArray<physgen::StoredArray<Stored, tags::patches::changes, ::quasistatic::PatchChangeArray<Real,
      Space>>, PatchesChangesFormats> changes;

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
    physgen::allocate(changes, counts.change);
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
struct edges { static constexpr const char* name = "level.edges"; };
struct node_edge_ranges { static constexpr const char* name = "level.node_edge_ranges"; };
struct node_edge_entries { static constexpr const char* name = "level.node_edge_entries"; };
struct node_stiffness { static constexpr const char* name = "level.node_stiffness"; };
struct edge_stiffness { static constexpr const char* name = "level.edge_stiffness"; };
struct scales { static constexpr const char* name = "level.scales"; };
struct scaled_nodes { static constexpr const char* name = "level.scaled_nodes"; };
struct scaled_edges { static constexpr const char* name = "level.scaled_edges"; };
struct inverse { static constexpr const char* name = "level.inverse"; };
struct smoother { static constexpr const char* name = "level.smoother"; };
struct residual { static constexpr const char* name = "level.residual"; };
struct correction { static constexpr const char* name = "level.correction"; };
struct direction { static constexpr const char* name = "level.direction"; };
struct power { static constexpr const char* name = "level.power"; };
struct parents { static constexpr const char* name = "level.parents"; };
struct grid_parents { static constexpr const char* name = "level.grid_parents"; struct nodes; struct weights; };
struct child_ranges { static constexpr const char* name = "level.child_ranges"; };
struct child_entries { static constexpr const char* name = "level.child_entries"; };
struct edge_term_ranges { static constexpr const char* name = "level.edge_term_ranges"; };
struct edge_term_entries { static constexpr const char* name = "level.edge_term_entries"; };
struct translations { static constexpr const char* name = "level.translations"; struct T; };
struct coarse_inverse { static constexpr const char* name = "level.coarse_inverse"; };
}  // namespace tags::level

/// How quasistatic::GridParents is stored in level.grid_parents. Not stored:
/// - nodes, weights: it is an input; nothing reads it
template <class Stored>
struct LevelGrid_parentsFormats : Stored {
  using nodes = physgen::format::Pruned<implicit_dynamics, tags::level::grid_parents, tags::level::grid_parents::nodes>;
  using weights = physgen::format::Pruned<implicit_dynamics, tags::level::grid_parents,
      tags::level::grid_parents::weights>;
};

/// How quasistatic::TranslationStiffness is stored in level.translations. Not stored:
/// - T: nothing uses it
template <class Stored>
struct LevelTranslationsFormats : Stored {
  using T = physgen::format::Pruned<implicit_dynamics, tags::level::translations, tags::level::translations::T>;
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
  /// elasticity::Edge, per edge: nodes
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::level::edges, ::elasticity::EdgeArray<Real, Space>>> edges;
  /// Rows of NodeEdgeEntry.
  /// elasticity::IncidenceRange, per edge_node: begin, end
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::level::node_edge_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>> node_edge_ranges;
  /// quasistatic::PackedIncidence, per edge_end: code
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::level::node_edge_entries,
      ::quasistatic::PackedIncidenceArray<float, Space>>> node_edge_entries;
  /// elasticity::NodeStiffness, per block_node: K
  physgen::StoredArray<Stored, tags::level::node_stiffness, ::elasticity::NodeStiffnessArray<Real,
      Space>> node_stiffness;
  /// elasticity::EdgeStiffness, per edge: E
  physgen::StoredArray<Stored, tags::level::edge_stiffness, ::elasticity::EdgeStiffnessArray<Real,
      Space>> edge_stiffness;
  /// quasistatic::NodeScale, per node: scale, inverse
  physgen::StoredArray<Stored, tags::level::scales, ::quasistatic::NodeScaleArray<Real, Space>> scales;
  /// elasticity::NodeStiffness, per edge_node: K
  physgen::StoredArray<Stored, tags::level::scaled_nodes, ::elasticity::NodeStiffnessArray<Real, Space>> scaled_nodes;
  /// elasticity::EdgeStiffness, per edge: E
  physgen::StoredArray<Stored, tags::level::scaled_edges, ::elasticity::EdgeStiffnessArray<Real, Space>> scaled_edges;
  /// quasistatic::NodeInverse, per block_node: D
  physgen::StoredArray<Stored, tags::level::inverse, ::quasistatic::NodeInverseArray<Real, Space>> inverse;
  /// quasistatic::Smoother, per smoother: largest, length
  physgen::StoredArray<Stored, tags::level::smoother, ::quasistatic::SmootherArray<double, Space>> smoother;
  /// r
  /// elasticity::NodeForceDifferential, per node: df
  physgen::StoredArray<Stored, tags::level::residual, ::elasticity::NodeForceDifferentialArray<Real, Space>> residual;
  /// z
  /// elasticity::NodeDisplacement, per node: dx
  physgen::StoredArray<Stored, tags::level::correction, ::elasticity::NodeDisplacementArray<Real, Space>> correction;
  /// d
  /// elasticity::NodeDisplacement, per edge_node: dx
  physgen::StoredArray<Stored, tags::level::direction, ::elasticity::NodeDisplacementArray<Real, Space>> direction;
  /// The eigenvector that power iterations approach.
  /// elasticity::NodeDisplacement, per edge_node: dx
  physgen::StoredArray<Stored, tags::level::power, ::elasticity::NodeDisplacementArray<Real, Space>> power;
  /// quasistatic::NodeParents, per child: nodes
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::level::parents, ::quasistatic::NodeParentsArray<Real,
      Space>>> parents;
  /// In place of `parents`, to a background grid.
  /// quasistatic::GridParents, per grid_child: left out, takes stores
  physgen::ReadOnlyArray<physgen::PrunedArray<physgen::StoredArray<Stored, tags::level::grid_parents,
      ::quasistatic::GridParentsArray<Real, Space>>, LevelGrid_parentsFormats>> grid_parents;
  /// The children of each node of the coarser level: rows of ChildEntry.
  /// elasticity::IncidenceRange, per parent: begin, end
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::level::child_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>> child_ranges;
  /// quasistatic::PackedIncidence, per child_entry: code
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::level::child_entries,
      ::quasistatic::PackedIncidenceArray<float, Space>>> child_entries;
  /// The terms of each edge of the coarser level: rows of EdgeTermEntry.
  /// elasticity::IncidenceRange, per coarse_edge: begin, end
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::level::edge_term_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>> edge_term_ranges;
  /// quasistatic::PackedIncidence, per edge_term: code
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::level::edge_term_entries,
      ::quasistatic::PackedIncidenceArray<float, Space>>> edge_term_entries;
  /// The levels of a background grid, and the mesh on it, have these.
  /// quasistatic::TranslationStiffness, per grid_node: left out, takes stores
  physgen::PrunedArray<physgen::StoredArray<Stored, tags::level::translations,
      ::quasistatic::TranslationStiffnessArray<Real, Space>>, LevelTranslationsFormats> translations;
  /// The coarsest level alone has it.
  /// quasistatic::CoarseInverse, per coarse_pair: G
  physgen::StoredArray<Stored, tags::level::coarse_inverse, ::quasistatic::CoarseInverseArray<Real,
      Space>> coarse_inverse;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(constraints, counts.node);
    physgen::allocate(edges, counts.edge);
    physgen::allocate(node_edge_ranges, counts.edge_node);
    physgen::allocate(node_edge_entries, counts.edge_end);
    physgen::allocate(node_stiffness, counts.block_node, {"K"});
    physgen::allocate(edge_stiffness, counts.edge, {"E"});
    physgen::allocate(scales, counts.node);
    physgen::allocate(scaled_nodes, counts.edge_node, {"K"});
    physgen::allocate(scaled_edges, counts.edge, {"E"});
    physgen::allocate(inverse, counts.block_node, {"D"});
    physgen::allocate(smoother, counts.smoother, {"largest", "length"});
    physgen::allocate(residual, counts.node, {"df"});
    physgen::allocate(correction, counts.node, {"dx"});
    physgen::allocate(direction, counts.edge_node, {"dx"});
    physgen::allocate(power, counts.edge_node, {"dx"});
    physgen::allocate(parents, counts.child);
    physgen::allocate(grid_parents, counts.grid_child);
    physgen::allocate(child_ranges, counts.parent);
    physgen::allocate(child_entries, counts.child_entry);
    physgen::allocate(edge_term_ranges, counts.coarse_edge);
    physgen::allocate(edge_term_entries, counts.edge_term);
    physgen::allocate(translations, counts.grid_node);
    physgen::allocate(coarse_inverse, counts.coarse_pair, {"G"});
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

namespace tags::inertia {
struct masses { static constexpr const char* name = "inertia.masses"; };
struct centres { static constexpr const char* name = "inertia.centres"; };
struct velocities { static constexpr const char* name = "inertia.velocities"; };
struct measured { static constexpr const char* name = "inertia.measured"; };
}  // namespace tags::inertia

template <class Space_ = physgen::Host, class Real_ = float, class Stored_ = physgen::StoredAsDeclared>
struct Inertia {
  using Space = Space_;
  using Real = Real_;
  using Stored = Stored_;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t node = 0;
    physgen::index_t moving_node = 0;
    physgen::index_t measure = 0;
  };

  /// dynamics::NodeMass, per node: mass
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::inertia::masses, ::dynamics::NodeMassArray<double,
      Space>>> masses;
  /// Before the first time step they do nothing, but are read.
  /// elasticity::NodePosition, per moving_node: x
  physgen::StoredArray<Stored, tags::inertia::centres, ::elasticity::NodePositionArray<double, Space>> centres;
  /// dynamics::NodeVelocity, per moving_node: v
  physgen::StoredArray<Stored, tags::inertia::velocities, ::dynamics::NodeVelocityArray<double, Space>> velocities;
  /// Without elastic energy, which stands in the body's state: here it stays what it is at the beginning.
  /// dynamics::Motion, per measure: kinetic, momentum, elastic, farthest
  physgen::StoredArray<Stored, tags::inertia::measured, ::dynamics::MotionArray<double, Space>> measured;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(masses, counts.node);
    physgen::allocate(centres, counts.moving_node);
    physgen::allocate(velocities, counts.moving_node);
    physgen::allocate(measured, counts.measure, {"kinetic", "momentum", "farthest"});
  }

  /// Bytes of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return masses.bytes() + centres.bytes() + velocities.bytes() + measured.bytes();
  }
  /// The same of arrays of so many objects, without making them. @pre no count is negative
  [[nodiscard]] static constexpr physgen::index_t bytes(const Counts& counts) {
    return physgen::bytes_of_array<decltype(masses)>(counts.node) +
           physgen::bytes_of_array<decltype(centres)>(counts.moving_node) +
           physgen::bytes_of_array<decltype(velocities)>(counts.moving_node) +
           physgen::bytes_of_array<decltype(measured)>(counts.measure);
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

}  // namespace scenes::implicit_dynamics_scene
