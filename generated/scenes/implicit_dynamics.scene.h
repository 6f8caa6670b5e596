// Arrays of the scene implicit_dynamics, with the fields that its program needs. Written by physgen from
// scenes/implicit_dynamics.h and the kernels that it runs: change these, not this file.
#pragma once

#include <physgen/scene_arrays.h>

#include "scenes/implicit_dynamics.h"

/// Motion of a stable Neo-Hookean body: one step of backward Euler with lumped mass and damping, whose equilibrium is
/// found as that of the scene quasistatic. Volumes are averaged over patches of tets.
namespace scenes::implicit_dynamics_scene {

template <class Space_ = physgen::Host>
struct Body {
  using Space = Space_;
  using Real = float;

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
  physgen::ReadOnlyArray<::elasticity::TetArray<float, Space>> tets;
  /// The tets of each node: rows of NodeTetEntry.
  /// elasticity::IncidenceRange, per node: begin, end
  physgen::ReadOnlyArray<::elasticity::IncidenceRangeArray<float, Space>> node_tet_ranges;
  /// quasistatic::PackedIncidence, per corner: code
  physgen::ReadOnlyArray<::quasistatic::PackedIncidenceArray<float, Space>> node_tet_entries;
  /// The tets of each edge: rows of EdgeTetEntry. None where the stiffness is not assembled.
  /// elasticity::IncidenceRange, per edge: begin, end
  physgen::ReadOnlyArray<::elasticity::IncidenceRangeArray<float, Space>> edge_tet_ranges;
  /// quasistatic::PackedIncidence, per tet_edge: code
  physgen::ReadOnlyArray<::quasistatic::PackedIncidenceArray<float, Space>> edge_tet_entries;
  /// Of each patch or node where volumes are averaged.
  /// quasistatic::MeanVolume, per volume: volume, ratio, pressure, linearised, tangent_pressure, before, full
  ::quasistatic::MeanVolumeArray<double, Space> volumes;
  /// elasticity::NodePosition, per node: x
  physgen::ReadOnlyArray<::elasticity::NodePositionArray<double, Space>> rest;
  /// Of the last equilibrium, or of the step under way.
  /// elasticity::NodePosition, per node: x
  ::elasticity::NodePositionArray<double, Space> positions;
  /// Where a step leads.
  /// elasticity::NodePosition, per node: x
  ::elasticity::NodePositionArray<double, Space> trial;
  /// Where the load increment began.
  /// elasticity::NodePosition, per node: x
  ::elasticity::NodePositionArray<double, Space> kept;
  /// External, at a load of 1.
  /// elasticity::NodeForce, per node: f
  physgen::ReadOnlyArray<::elasticity::NodeForceArray<double, Space>> loads;
  /// Of prescribed components, at a load of 1.
  /// elasticity::NodeDisplacement, per node: dx
  physgen::ReadOnlyArray<::elasticity::NodeDisplacementArray<double, Space>> motion;
  /// Elastic and external; in prescribed components minus the reaction.
  /// elasticity::NodeForce, per node: f
  ::elasticity::NodeForceArray<double, Space> forces;
  /// elasticity::NodeForce, per node: f
  ::elasticity::NodeForceArray<double, Space> trial_forces;
  /// Of prescribed components.
  /// elasticity::NodeDisplacement, per node: dx
  ::elasticity::NodeDisplacementArray<double, Space> increment;
  /// Its volumetric energy is 0 where no volumes are averaged.
  /// quasistatic::Equilibrium, 1 object: elastic, volumetric, loads, free_square, fixed_square, work, smallest_ratio
  ::quasistatic::EquilibriumArray<double, Space> state;

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

  /// Of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return tets.bytes(
        ) + node_tet_ranges.bytes() + node_tet_entries.bytes() + edge_tet_ranges.bytes() + edge_tet_entries.bytes() +
            volumes.bytes() + rest.bytes() + positions.bytes() + trial.bytes() + kept.bytes() + loads.bytes() +
                motion.bytes() + forces.bytes() + trial_forces.bytes() + increment.bytes() + state.bytes();
  }
};

namespace pruned::patches {
struct parents {
  struct patch;
};
}  // namespace pruned::patches

/// How quasistatic::PatchParent is stored in patches.parents. Not stored:
/// - patch: it is an input; nothing reads it
template <class Space>
struct PatchesParentsFormats : physgen::FormatsOf<::quasistatic::PatchParentObject, Space> {
  using patch = physgen::format::Pruned<implicit_dynamics, pruned::patches::parents, pruned::patches::parents::patch>;
};

namespace pruned::patches {
struct node_patch_ranges {
  struct begin;
  struct end;
};
}  // namespace pruned::patches

/// How elasticity::IncidenceRange is stored in patches.node_patch_ranges. Not stored:
/// - begin, end: it is an input; nothing reads it
template <class Space>
struct PatchesNode_patch_rangesFormats : physgen::FormatsOf<::elasticity::IncidenceRangeObject, Space> {
  using begin = physgen::format::Pruned<implicit_dynamics, pruned::patches::node_patch_ranges,
      pruned::patches::node_patch_ranges::begin>;
  using end = physgen::format::Pruned<implicit_dynamics, pruned::patches::node_patch_ranges,
      pruned::patches::node_patch_ranges::end>;
};

namespace pruned::patches {
struct node_patch_entries {
  struct code;
};
}  // namespace pruned::patches

/// How quasistatic::PackedIncidence is stored in patches.node_patch_entries. Not stored:
/// - code: it is an input; nothing reads it
template <class Space>
struct PatchesNode_patch_entriesFormats : physgen::FormatsOf<::quasistatic::PackedIncidenceObject, Space> {
  using code = physgen::format::Pruned<implicit_dynamics, pruned::patches::node_patch_entries,
      pruned::patches::node_patch_entries::code>;
};

namespace pruned::patches {
struct changes {
  struct change;
};
}  // namespace pruned::patches

/// How quasistatic::PatchChange is stored in patches.changes. Not stored:
/// - change: nothing uses it
template <class Space>
struct PatchesChangesFormats : physgen::FormatsOf<::quasistatic::PatchChangeObject, Space> {
  using change = physgen::format::Pruned<implicit_dynamics, pruned::patches::changes, pruned::patches::changes::change>;
};

template <class Space_ = physgen::Host>
struct Patches {
  using Space = Space_;
  using Real = float;

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
  physgen::ReadOnlyArray<::quasistatic::TetPatchArray<float, Space>> tet_patches;
  /// quasistatic::PatchNodes, per patch: nodes
  physgen::ReadOnlyArray<::quasistatic::PatchNodesArray<float, Space>> nodes;
  /// Where there is a coarser level.
  /// quasistatic::PatchParent, per child: left out, takes stores
  physgen::ReadOnlyArray<physgen::WithFormats<::quasistatic::PatchParentArray<float, Space>,
      PatchesParentsFormats<Space>>> parents;
  /// elasticity::IncidenceRange, per patch: begin, end
  physgen::ReadOnlyArray<::elasticity::IncidenceRangeArray<float, Space>> patch_tet_ranges;
  /// quasistatic::PatchTet, per tet: tet, slots
  physgen::ReadOnlyArray<::quasistatic::PatchTetArray<float, Space>> patch_tet_entries;
  /// Rows of EdgePatchEntry, where the stiffness is assembled.
  /// elasticity::IncidenceRange, per edge: begin, end
  physgen::ReadOnlyArray<::elasticity::IncidenceRangeArray<float, Space>> edge_patch_ranges;
  /// quasistatic::PackedIncidence, per edge_patch: code
  physgen::ReadOnlyArray<::quasistatic::PackedIncidenceArray<float, Space>> edge_patch_entries;
  /// Rows of NodePatchEntry, where it is not.
  /// elasticity::IncidenceRange, per node: left out, takes stores
  physgen::ReadOnlyArray<physgen::WithFormats<::elasticity::IncidenceRangeArray<float, Space>,
      PatchesNode_patch_rangesFormats<Space>>> node_patch_ranges;
  /// quasistatic::PackedIncidence, per node_patch: left out, takes stores
  physgen::ReadOnlyArray<physgen::WithFormats<::quasistatic::PackedIncidenceArray<float, Space>,
      PatchesNode_patch_entriesFormats<Space>>> node_patch_entries;
  /// quasistatic::PatchTangent, per patch: g, k
  ::quasistatic::PatchTangentArray<float, Space> tangent;
  /// Of products without blocks of edges, on the CPU.
  /// quasistatic::PatchChange, per change: left out, takes stores
  physgen::WithFormats<::quasistatic::PatchChangeArray<float, Space>, PatchesChangesFormats<Space>> changes;

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

  /// Of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return tet_patches.bytes(
        ) + nodes.bytes() + parents.bytes() + patch_tet_ranges.bytes() + patch_tet_entries.bytes() +
            edge_patch_ranges.bytes() + edge_patch_entries.bytes() + node_patch_ranges.bytes() +
                node_patch_entries.bytes() + tangent.bytes() + changes.bytes();
  }
};

template <class Space_ = physgen::Host>
struct Chunk {
  using Space = Space_;
  using Real = float;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t chunk_tet = 0;
    physgen::index_t kept_tet = 0;
  };

  /// elasticity::CornerForces, per chunk_tet: G
  ::elasticity::CornerForcesArray<double, Space> corners;
  /// Of a chunk, or of all tets.
  /// quasistatic::TetTangent, per kept_tet: U, g, x1111, x2211, x3311, x2222, x3322, x3333, x2121, x2112, x3131, x3113,
  /// x3232, x3223
  ::quasistatic::TetTangentArray<float, Space> tangent;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(corners, counts.chunk_tet, {"G"});
    physgen::allocate(tangent, counts.kept_tet, {"U", "g", "x1111", "x2211", "x3311", "x2222", "x3322", "x3333",
        "x2121", "x2112", "x3131", "x3113", "x3232", "x3223"});
  }

  /// Of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const { return corners.bytes() + tangent.bytes(); }
};

namespace pruned::level {
struct grid_parents {
  struct nodes;
  struct weights;
};
}  // namespace pruned::level

/// How quasistatic::GridParents is stored in level.grid_parents. Not stored:
/// - nodes, weights: it is an input; nothing reads it
template <class Space>
struct LevelGrid_parentsFormats : physgen::FormatsOf<::quasistatic::GridParentsObject, Space> {
  using nodes = physgen::format::Pruned<implicit_dynamics, pruned::level::grid_parents,
      pruned::level::grid_parents::nodes>;
  using weights = physgen::format::Pruned<implicit_dynamics, pruned::level::grid_parents,
      pruned::level::grid_parents::weights>;
};

namespace pruned::level {
struct translations {
  struct T;
};
}  // namespace pruned::level

/// How quasistatic::TranslationStiffness is stored in level.translations. Not stored:
/// - T: nothing uses it
template <class Space>
struct LevelTranslationsFormats : physgen::FormatsOf<::quasistatic::TranslationStiffnessObject, Space> {
  using T = physgen::format::Pruned<implicit_dynamics, pruned::level::translations, pruned::level::translations::T>;
};

template <class Space_ = physgen::Host>
struct Level {
  using Space = Space_;
  using Real = float;

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
  physgen::ReadOnlyArray<::quasistatic::NodeConstraintArray<float, Space>> constraints;
  /// elasticity::Edge, per edge: nodes
  physgen::ReadOnlyArray<::elasticity::EdgeArray<float, Space>> edges;
  /// Rows of NodeEdgeEntry.
  /// elasticity::IncidenceRange, per edge_node: begin, end
  physgen::ReadOnlyArray<::elasticity::IncidenceRangeArray<float, Space>> node_edge_ranges;
  /// quasistatic::PackedIncidence, per edge_end: code
  physgen::ReadOnlyArray<::quasistatic::PackedIncidenceArray<float, Space>> node_edge_entries;
  /// elasticity::NodeStiffness, per block_node: K
  ::elasticity::NodeStiffnessArray<float, Space> node_stiffness;
  /// elasticity::EdgeStiffness, per edge: E
  ::elasticity::EdgeStiffnessArray<float, Space> edge_stiffness;
  /// quasistatic::NodeScale, per node: scale, inverse
  ::quasistatic::NodeScaleArray<float, Space> scales;
  /// elasticity::NodeStiffness, per edge_node: K
  ::elasticity::NodeStiffnessArray<float, Space> scaled_nodes;
  /// elasticity::EdgeStiffness, per edge: E
  ::elasticity::EdgeStiffnessArray<float, Space> scaled_edges;
  /// quasistatic::NodeInverse, per block_node: D
  ::quasistatic::NodeInverseArray<float, Space> inverse;
  /// quasistatic::Smoother, per smoother: largest, length
  ::quasistatic::SmootherArray<double, Space> smoother;
  /// r
  /// elasticity::NodeForceDifferential, per node: df
  ::elasticity::NodeForceDifferentialArray<float, Space> residual;
  /// z
  /// elasticity::NodeDisplacement, per node: dx
  ::elasticity::NodeDisplacementArray<float, Space> correction;
  /// d
  /// elasticity::NodeDisplacement, per edge_node: dx
  ::elasticity::NodeDisplacementArray<float, Space> direction;
  /// The eigenvector that power iterations approach.
  /// elasticity::NodeDisplacement, per edge_node: dx
  ::elasticity::NodeDisplacementArray<float, Space> power;
  /// quasistatic::NodeParents, per child: nodes
  physgen::ReadOnlyArray<::quasistatic::NodeParentsArray<float, Space>> parents;
  /// In place of `parents`, to a background grid.
  /// quasistatic::GridParents, per grid_child: left out, takes stores
  physgen::ReadOnlyArray<physgen::WithFormats<::quasistatic::GridParentsArray<float, Space>,
      LevelGrid_parentsFormats<Space>>> grid_parents;
  /// Of each node of the coarser level: rows of ChildEntry.
  /// elasticity::IncidenceRange, per parent: begin, end
  physgen::ReadOnlyArray<::elasticity::IncidenceRangeArray<float, Space>> child_ranges;
  /// quasistatic::PackedIncidence, per child_entry: code
  physgen::ReadOnlyArray<::quasistatic::PackedIncidenceArray<float, Space>> child_entries;
  /// Of each edge of the coarser level: rows of EdgeTermEntry.
  /// elasticity::IncidenceRange, per coarse_edge: begin, end
  physgen::ReadOnlyArray<::elasticity::IncidenceRangeArray<float, Space>> edge_term_ranges;
  /// quasistatic::PackedIncidence, per edge_term: code
  physgen::ReadOnlyArray<::quasistatic::PackedIncidenceArray<float, Space>> edge_term_entries;
  /// Of levels of a background grid, and of the mesh on it.
  /// quasistatic::TranslationStiffness, per grid_node: left out, takes stores
  physgen::WithFormats<::quasistatic::TranslationStiffnessArray<float, Space>,
      LevelTranslationsFormats<Space>> translations;
  /// Of the coarsest level alone.
  /// quasistatic::CoarseInverse, per coarse_pair: G
  ::quasistatic::CoarseInverseArray<float, Space> coarse_inverse;

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

  /// Of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return constraints.bytes(
        ) + edges.bytes() + node_edge_ranges.bytes() + node_edge_entries.bytes() + node_stiffness.bytes() +
            edge_stiffness.bytes() + scales.bytes() + scaled_nodes.bytes() + scaled_edges.bytes() + inverse.bytes() +
                smoother.bytes() + residual.bytes() + correction.bytes() + direction.bytes() + power.bytes() +
                    parents.bytes() + grid_parents.bytes() + child_ranges.bytes() + child_entries.bytes() +
                        edge_term_ranges.bytes() + edge_term_entries.bytes() + translations.bytes() +
                            coarse_inverse.bytes();
  }
};

template <class Space_ = physgen::Host>
struct Inertia {
  using Space = Space_;
  using Real = float;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t node = 0;
    physgen::index_t moving_node = 0;
    physgen::index_t measure = 0;
  };

  /// dynamics::NodeMass, per node: mass
  physgen::ReadOnlyArray<::dynamics::NodeMassArray<double, Space>> masses;
  /// elasticity::NodePosition, per moving_node: x
  ::elasticity::NodePositionArray<double, Space> centres;
  /// dynamics::NodeVelocity, per moving_node: v
  ::dynamics::NodeVelocityArray<double, Space> velocities;
  /// Without elastic energy, which stands in the body's state: here it stays what it is at the beginning.
  /// dynamics::Motion, per measure: kinetic, momentum, elastic, farthest
  ::dynamics::MotionArray<double, Space> measured;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(masses, counts.node);
    physgen::allocate(centres, counts.moving_node, {"x"});
    physgen::allocate(velocities, counts.moving_node);
    physgen::allocate(measured, counts.measure, {"kinetic", "momentum", "farthest"});
  }

  /// Of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return masses.bytes() + centres.bytes() + velocities.bytes() + measured.bytes();
  }
};

template <class Space_ = physgen::Host>
struct Krylov {
  using Space = Space_;
  using Real = float;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t node = 0;
  };

  /// dx
  /// elasticity::NodeDisplacement, per node: dx
  ::elasticity::NodeDisplacementArray<float, Space> step;
  /// r = f + K dx
  /// elasticity::NodeForceDifferential, per node: df
  ::elasticity::NodeForceDifferentialArray<float, Space> residual;
  /// p
  /// elasticity::NodeDisplacement, per node: dx
  ::elasticity::NodeDisplacementArray<float, Space> direction;
  /// K p
  /// elasticity::NodeForceDifferential, per node: df
  ::elasticity::NodeForceDifferentialArray<float, Space> product;
  /// quasistatic::LinearSolve, 1 object: rz, rz_first, tolerance, alpha, beta, iterations, status
  ::quasistatic::LinearSolveArray<double, Space> state;

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

  /// Of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return step.bytes() + residual.bytes() + direction.bytes() + product.bytes() + state.bytes();
  }
};

}  // namespace scenes::implicit_dynamics_scene
