// Arrays of the scene everything, with the fields that its program needs. Written by physgen from scenes/everything.h
// and the kernels that it runs: change these, not this file.
#pragma once

#include <physgen/scenes/scene_arrays.h>

#include <contact.physgen.h>
#include <dynamics.physgen.h>
#include <elasticity.physgen.h>
#include <quasistatic.physgen.h>

namespace scenes { struct everything; }

/// Equilibrium and motion of a body with every choice that there is: volumes of tets, patches or nodes; products
/// assembled or by tets; each preconditioner, on meshes and background grids, stored as computed or in half; rigid
/// planes; pressures that follow the surface; and inertia.
namespace scenes::everything_scene {

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
struct parents { static constexpr const char* name = "patches.parents"; };
struct patch_tet_ranges { static constexpr const char* name = "patches.patch_tet_ranges"; };
struct patch_tet_entries { static constexpr const char* name = "patches.patch_tet_entries"; };
struct edge_patch_ranges { static constexpr const char* name = "patches.edge_patch_ranges"; };
struct edge_patch_entries { static constexpr const char* name = "patches.edge_patch_entries"; };
struct node_patch_ranges { static constexpr const char* name = "patches.node_patch_ranges"; };
struct node_patch_entries { static constexpr const char* name = "patches.node_patch_entries"; };
struct tangent { static constexpr const char* name = "patches.tangent"; };
struct changes { static constexpr const char* name = "patches.changes"; };
}  // namespace tags::patches

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
  /// elasticity::IncidenceRange, per edge: begin, end
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::patches::edge_patch_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>> edge_patch_ranges;
  /// quasistatic::PackedIncidence, per edge_patch: code
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::patches::edge_patch_entries,
      ::quasistatic::PackedIncidenceArray<float, Space>>> edge_patch_entries;
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

namespace tags::rings {
struct node_ranges { static constexpr const char* name = "rings.node_ranges"; };
struct node_entries { static constexpr const char* name = "rings.node_entries"; };
struct tangent { static constexpr const char* name = "rings.tangent"; };
}  // namespace tags::rings

template <class Space_ = physgen::Host, class Real_ = float, class Stored_ = physgen::StoredAsDeclared>
struct Rings {
  using Space = Space_;
  using Real = Real_;
  using Stored = Stored_;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t node = 0;
    physgen::index_t neighbour = 0;
  };

  /// The nodes of each node's ring, ascending.
  /// elasticity::IncidenceRange, per node: begin, end
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::rings::node_ranges, ::elasticity::IncidenceRangeArray<float,
      Space>>> node_ranges;
  /// quasistatic::RingNode, per neighbour: node, g
  physgen::StoredArray<Stored, tags::rings::node_entries, ::quasistatic::RingNodeArray<Real, Space>> node_entries;
  /// quasistatic::NodeVolumeTangent, per node: k
  physgen::StoredArray<Stored, tags::rings::tangent, ::quasistatic::NodeVolumeTangentArray<Real, Space>> tangent;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(node_ranges, counts.node);
    physgen::allocate(node_entries, counts.neighbour, {"g"});
    physgen::allocate(tangent, counts.node, {"k"});
  }

  /// Bytes of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return node_ranges.bytes() + node_entries.bytes() + tangent.bytes();
  }
  /// The same of arrays of so many objects, without making them. @pre no count is negative
  [[nodiscard]] static constexpr physgen::index_t bytes(const Counts& counts) {
    return physgen::bytes_of_array<decltype(node_ranges)>(counts.node) +
           physgen::bytes_of_array<decltype(node_entries)>(counts.neighbour) +
           physgen::bytes_of_array<decltype(tangent)>(counts.node);
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
struct grid_parents { static constexpr const char* name = "level.grid_parents"; };
struct child_ranges { static constexpr const char* name = "level.child_ranges"; };
struct child_entries { static constexpr const char* name = "level.child_entries"; };
struct edge_term_ranges { static constexpr const char* name = "level.edge_term_ranges"; };
struct edge_term_entries { static constexpr const char* name = "level.edge_term_entries"; };
struct translations { static constexpr const char* name = "level.translations"; };
struct coarse_inverse { static constexpr const char* name = "level.coarse_inverse"; };
}  // namespace tags::level

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
  /// quasistatic::GridParents, per grid_child: nodes, weights
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::level::grid_parents, ::quasistatic::GridParentsArray<Real,
      Space>>> grid_parents;
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
  /// quasistatic::TranslationStiffness, per grid_node: T
  physgen::StoredArray<Stored, tags::level::translations, ::quasistatic::TranslationStiffnessArray<Real,
      Space>> translations;
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
    physgen::allocate(translations, counts.grid_node, {"T"});
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

namespace tags::schwarz {
struct nodes { static constexpr const char* name = "schwarz.nodes"; };
struct slots { static constexpr const char* name = "schwarz.slots"; };
struct blocks { static constexpr const char* name = "schwarz.blocks"; };
struct supernode_term_ranges { static constexpr const char* name = "schwarz.supernode_term_ranges"; };
struct supernode_term_entries { static constexpr const char* name = "schwarz.supernode_term_entries"; };
struct pair_term_ranges { static constexpr const char* name = "schwarz.pair_term_ranges"; };
struct pair_term_entries { static constexpr const char* name = "schwarz.pair_term_entries"; };
struct block_edge_ranges { static constexpr const char* name = "schwarz.block_edge_ranges"; };
struct block_edge_entries { static constexpr const char* name = "schwarz.block_edge_entries"; };
struct supernodes { static constexpr const char* name = "schwarz.supernodes"; };
struct pair_stiffness { static constexpr const char* name = "schwarz.pair_stiffness"; };
struct residual { static constexpr const char* name = "schwarz.residual"; };
struct correction { static constexpr const char* name = "schwarz.correction"; };
struct factors { static constexpr const char* name = "schwarz.factors"; };
}  // namespace tags::schwarz

template <class Space_ = physgen::Host, class Real_ = float, class Stored_ = physgen::StoredAsDeclared>
struct Schwarz {
  using Space = Space_;
  using Real = Real_;
  using Stored = Stored_;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t node = 0;
    physgen::index_t slot = 0;
    physgen::index_t block = 0;
    physgen::index_t supernode = 0;
    physgen::index_t supernode_term = 0;
    physgen::index_t pair = 0;
    physgen::index_t pair_term = 0;
    physgen::index_t block_edge = 0;
    physgen::index_t factor = 0;
  };

  /// quasistatic::SchwarzNode, per node: slot
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::schwarz::nodes, ::quasistatic::SchwarzNodeArray<Real,
      Space>>> nodes;
  /// quasistatic::SchwarzSlot, per slot: source, parent
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::schwarz::slots, ::quasistatic::SchwarzSlotArray<Real,
      Space>>> slots;
  /// quasistatic::SchwarzBlock, per block: scale, parent, children, arrived
  physgen::StoredArray<Stored, tags::schwarz::blocks, ::quasistatic::SchwarzBlockArray<Real, Space>> blocks;
  /// elasticity::IncidenceRange, per supernode: begin, end
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::schwarz::supernode_term_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>> supernode_term_ranges;
  /// quasistatic::SchwarzTerm, per supernode_term: source, kind
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::schwarz::supernode_term_entries,
      ::quasistatic::SchwarzTermArray<float, Space>>> supernode_term_entries;
  /// elasticity::IncidenceRange, per pair: begin, end
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::schwarz::pair_term_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>> pair_term_ranges;
  /// quasistatic::SchwarzTerm, per pair_term: source, kind
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::schwarz::pair_term_entries,
      ::quasistatic::SchwarzTermArray<float, Space>>> pair_term_entries;
  /// elasticity::IncidenceRange, per block: begin, end
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::schwarz::block_edge_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>> block_edge_ranges;
  /// quasistatic::SchwarzPair, per block_edge: edge, places
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::schwarz::block_edge_entries,
      ::quasistatic::SchwarzPairArray<float, Space>>> block_edge_entries;
  /// quasistatic::Supernode, per supernode: K, magnitude
  physgen::StoredArray<Stored, tags::schwarz::supernodes, ::quasistatic::SupernodeArray<Real, Space>> supernodes;
  /// elasticity::EdgeStiffness, per pair: E
  physgen::StoredArray<Stored, tags::schwarz::pair_stiffness, ::elasticity::EdgeStiffnessArray<Real,
      Space>> pair_stiffness;
  /// r, summed over the nodes of each supernode.
  /// elasticity::NodeForceDifferential, per supernode: df
  physgen::StoredArray<Stored, tags::schwarz::residual, ::elasticity::NodeForceDifferentialArray<Real, Space>> residual;
  /// z
  /// elasticity::NodeDisplacement, per supernode: dx
  physgen::StoredArray<Stored, tags::schwarz::correction, ::elasticity::NodeDisplacementArray<Real, Space>> correction;
  /// quasistatic::SchwarzFactor, per factor: W
  physgen::StoredArray<Stored, tags::schwarz::factors, ::quasistatic::SchwarzFactorArray<Real, Space>> factors;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(nodes, counts.node);
    physgen::allocate(slots, counts.slot);
    physgen::allocate(blocks, counts.block, {"scale"});
    physgen::allocate(supernode_term_ranges, counts.supernode);
    physgen::allocate(supernode_term_entries, counts.supernode_term);
    physgen::allocate(pair_term_ranges, counts.pair);
    physgen::allocate(pair_term_entries, counts.pair_term);
    physgen::allocate(block_edge_ranges, counts.block);
    physgen::allocate(block_edge_entries, counts.block_edge);
    physgen::allocate(supernodes, counts.supernode, {"K", "magnitude"});
    physgen::allocate(pair_stiffness, counts.pair, {"E"});
    physgen::allocate(residual, counts.supernode, {"df"});
    physgen::allocate(correction, counts.supernode, {"dx"});
    physgen::allocate(factors, counts.factor, {"W"});
  }

  /// Bytes of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return nodes.bytes() + slots.bytes() + blocks.bytes() + supernode_term_ranges.bytes() +
           supernode_term_entries.bytes() + pair_term_ranges.bytes() + pair_term_entries.bytes() +
           block_edge_ranges.bytes() + block_edge_entries.bytes() + supernodes.bytes() + pair_stiffness.bytes() +
           residual.bytes() + correction.bytes() + factors.bytes();
  }
  /// The same of arrays of so many objects, without making them. @pre no count is negative
  [[nodiscard]] static constexpr physgen::index_t bytes(const Counts& counts) {
    return physgen::bytes_of_array<decltype(nodes)>(counts.node) +
           physgen::bytes_of_array<decltype(slots)>(counts.slot) +
           physgen::bytes_of_array<decltype(blocks)>(counts.block) +
           physgen::bytes_of_array<decltype(supernode_term_ranges)>(counts.supernode) +
           physgen::bytes_of_array<decltype(supernode_term_entries)>(counts.supernode_term) +
           physgen::bytes_of_array<decltype(pair_term_ranges)>(counts.pair) +
           physgen::bytes_of_array<decltype(pair_term_entries)>(counts.pair_term) +
           physgen::bytes_of_array<decltype(block_edge_ranges)>(counts.block) +
           physgen::bytes_of_array<decltype(block_edge_entries)>(counts.block_edge) +
           physgen::bytes_of_array<decltype(supernodes)>(counts.supernode) +
           physgen::bytes_of_array<decltype(pair_stiffness)>(counts.pair) +
           physgen::bytes_of_array<decltype(residual)>(counts.supernode) +
           physgen::bytes_of_array<decltype(correction)>(counts.supernode) +
           physgen::bytes_of_array<decltype(factors)>(counts.factor);
  }
};

namespace tags::planes {
struct planes { static constexpr const char* name = "planes.planes"; };
struct areas { static constexpr const char* name = "planes.areas"; };
struct stiffness { static constexpr const char* name = "planes.stiffness"; };
struct contact { static constexpr const char* name = "planes.contact"; };
}  // namespace tags::planes

template <class Space_ = physgen::Host, class Real_ = float, class Stored_ = physgen::StoredAsDeclared>
struct Planes {
  using Space = Space_;
  using Real = Real_;
  using Stored = Stored_;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t plane = 0;
    physgen::index_t surface_node = 0;
    physgen::index_t node = 0;
    physgen::index_t contact = 0;
  };

  /// contact::RigidPlane, per plane: normal, offset, travel
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::planes::planes, ::contact::RigidPlaneArray<double,
      Space>>> planes;
  /// None where equilibrium is not solved.
  /// contact::NodeArea, per surface_node: area
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::planes::areas, ::contact::NodeAreaArray<double,
      Space>>> areas;
  /// The part of the nodes' blocks that planes have.
  /// elasticity::NodeStiffness, per node: K
  physgen::StoredArray<Stored, tags::planes::stiffness, ::elasticity::NodeStiffnessArray<Real, Space>> stiffness;
  /// How one plane and the body touch, where equilibrium is solved.
  /// contact::PlaneContact, per contact: force, depth
  physgen::StoredArray<Stored, tags::planes::contact, ::contact::PlaneContactArray<double, Space>> contact;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(planes, counts.plane);
    physgen::allocate(areas, counts.surface_node);
    physgen::allocate(stiffness, counts.node, {"K"});
    physgen::allocate(contact, counts.contact, {"force", "depth"});
  }

  /// Bytes of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return planes.bytes() + areas.bytes() + stiffness.bytes() + contact.bytes();
  }
  /// The same of arrays of so many objects, without making them. @pre no count is negative
  [[nodiscard]] static constexpr physgen::index_t bytes(const Counts& counts) {
    return physgen::bytes_of_array<decltype(planes)>(counts.plane) +
           physgen::bytes_of_array<decltype(areas)>(counts.surface_node) +
           physgen::bytes_of_array<decltype(stiffness)>(counts.node) +
           physgen::bytes_of_array<decltype(contact)>(counts.contact);
  }
};

namespace tags::surface {
struct faces { static constexpr const char* name = "surface.faces"; };
struct node_face_ranges { static constexpr const char* name = "surface.node_face_ranges"; };
struct node_face_entries { static constexpr const char* name = "surface.node_face_entries"; };
struct edge_face_ranges { static constexpr const char* name = "surface.edge_face_ranges"; };
struct edge_face_entries { static constexpr const char* name = "surface.edge_face_entries"; };
}  // namespace tags::surface

template <class Space_ = physgen::Host, class Real_ = float, class Stored_ = physgen::StoredAsDeclared>
struct Surface {
  using Space = Space_;
  using Real = Real_;
  using Stored = Stored_;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t face = 0;
    physgen::index_t node = 0;
    physgen::index_t face_corner = 0;
    physgen::index_t edge = 0;
  };

  /// contact::PressedFace, per face: nodes, pressure
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::surface::faces, ::contact::PressedFaceArray<double,
      Space>>> faces;
  /// The faces of each node, and those of each edge: rows of NodeTetEntry.
  /// elasticity::IncidenceRange, per node: begin, end
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::surface::node_face_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>> node_face_ranges;
  /// quasistatic::PackedIncidence, per face_corner: code
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::surface::node_face_entries,
      ::quasistatic::PackedIncidenceArray<float, Space>>> node_face_entries;
  /// elasticity::IncidenceRange, per edge: begin, end
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::surface::edge_face_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>> edge_face_ranges;
  /// quasistatic::PackedIncidence, per face_corner: code
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::surface::edge_face_entries,
      ::quasistatic::PackedIncidenceArray<float, Space>>> edge_face_entries;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(faces, counts.face);
    physgen::allocate(node_face_ranges, counts.node);
    physgen::allocate(node_face_entries, counts.face_corner);
    physgen::allocate(edge_face_ranges, counts.edge);
    physgen::allocate(edge_face_entries, counts.face_corner);
  }

  /// Bytes of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return faces.bytes() + node_face_ranges.bytes() + node_face_entries.bytes() + edge_face_ranges.bytes() +
           edge_face_entries.bytes();
  }
  /// The same of arrays of so many objects, without making them. @pre no count is negative
  [[nodiscard]] static constexpr physgen::index_t bytes(const Counts& counts) {
    return physgen::bytes_of_array<decltype(faces)>(counts.face) +
           physgen::bytes_of_array<decltype(node_face_ranges)>(counts.node) +
           physgen::bytes_of_array<decltype(node_face_entries)>(counts.face_corner) +
           physgen::bytes_of_array<decltype(edge_face_ranges)>(counts.edge) +
           physgen::bytes_of_array<decltype(edge_face_entries)>(counts.face_corner);
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

}  // namespace scenes::everything_scene
