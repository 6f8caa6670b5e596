// Arrays of the scene everything, with the fields that its program needs. Written by physgen from scenes/everything.h
// and the kernels that it runs: change these, not this file.
#pragma once

#include <physgen/scene_arrays.h>

#include "scenes/everything.h"

/// Equilibrium and motion of a body with every choice that there is: volumes of tets, patches or nodes; products
/// assembled or by tets; each preconditioner, on meshes and background grids, stored as computed or in half; rigid
/// planes; inertia.
namespace scenes::everything_scene {

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
  /// quasistatic::PatchParent, per child: patch
  physgen::ReadOnlyArray<::quasistatic::PatchParentArray<float, Space>> parents;
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
  /// elasticity::IncidenceRange, per node: begin, end
  physgen::ReadOnlyArray<::elasticity::IncidenceRangeArray<float, Space>> node_patch_ranges;
  /// quasistatic::PackedIncidence, per node_patch: code
  physgen::ReadOnlyArray<::quasistatic::PackedIncidenceArray<float, Space>> node_patch_entries;
  /// quasistatic::PatchTangent, per patch: g, k
  ::quasistatic::PatchTangentArray<float, Space> tangent;
  /// Of products without blocks of edges, on the CPU.
  /// quasistatic::PatchChange, per change: change
  ::quasistatic::PatchChangeArray<float, Space> changes;

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

  /// Of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return tet_patches.bytes(
        ) + nodes.bytes() + parents.bytes() + patch_tet_ranges.bytes() + patch_tet_entries.bytes() +
            edge_patch_ranges.bytes() + edge_patch_entries.bytes() + node_patch_ranges.bytes() +
                node_patch_entries.bytes() + tangent.bytes() + changes.bytes();
  }
};

template <class Space_ = physgen::Host>
struct Rings {
  using Space = Space_;
  using Real = float;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t node = 0;
    physgen::index_t neighbour = 0;
  };

  /// The nodes of each node's ring, ascending.
  /// elasticity::IncidenceRange, per node: begin, end
  physgen::ReadOnlyArray<::elasticity::IncidenceRangeArray<float, Space>> node_ranges;
  /// quasistatic::RingNode, per neighbour: node, g
  ::quasistatic::RingNodeArray<float, Space> node_entries;
  /// quasistatic::NodeVolumeTangent, per node: k
  ::quasistatic::NodeVolumeTangentArray<float, Space> tangent;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(node_ranges, counts.node);
    physgen::allocate(node_entries, counts.neighbour, {"g"});
    physgen::allocate(tangent, counts.node, {"k"});
  }

  /// Of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const { return node_ranges.bytes() + node_entries.bytes() + tangent.bytes(); }
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
  /// quasistatic::GridParents, per grid_child: nodes, weights
  physgen::ReadOnlyArray<::quasistatic::GridParentsArray<float, Space>> grid_parents;
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
  /// quasistatic::TranslationStiffness, per grid_node: T
  ::quasistatic::TranslationStiffnessArray<float, Space> translations;
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
    physgen::allocate(translations, counts.grid_node, {"T"});
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
struct Schwarz {
  using Space = Space_;
  using Real = float;

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
  physgen::ReadOnlyArray<::quasistatic::SchwarzNodeArray<float, Space>> nodes;
  /// quasistatic::SchwarzSlot, per slot: source, parent
  physgen::ReadOnlyArray<::quasistatic::SchwarzSlotArray<float, Space>> slots;
  /// quasistatic::SchwarzBlock, per block: scale, parent, children, arrived
  ::quasistatic::SchwarzBlockArray<float, Space> blocks;
  /// elasticity::IncidenceRange, per supernode: begin, end
  physgen::ReadOnlyArray<::elasticity::IncidenceRangeArray<float, Space>> supernode_term_ranges;
  /// quasistatic::SchwarzTerm, per supernode_term: source, kind
  physgen::ReadOnlyArray<::quasistatic::SchwarzTermArray<float, Space>> supernode_term_entries;
  /// elasticity::IncidenceRange, per pair: begin, end
  physgen::ReadOnlyArray<::elasticity::IncidenceRangeArray<float, Space>> pair_term_ranges;
  /// quasistatic::SchwarzTerm, per pair_term: source, kind
  physgen::ReadOnlyArray<::quasistatic::SchwarzTermArray<float, Space>> pair_term_entries;
  /// elasticity::IncidenceRange, per block: begin, end
  physgen::ReadOnlyArray<::elasticity::IncidenceRangeArray<float, Space>> block_edge_ranges;
  /// quasistatic::SchwarzPair, per block_edge: edge, places
  physgen::ReadOnlyArray<::quasistatic::SchwarzPairArray<float, Space>> block_edge_entries;
  /// quasistatic::Supernode, per supernode: K, magnitude
  ::quasistatic::SupernodeArray<float, Space> supernodes;
  /// elasticity::EdgeStiffness, per pair: E
  ::elasticity::EdgeStiffnessArray<float, Space> pair_stiffness;
  /// r, summed over the nodes of each supernode.
  /// elasticity::NodeForceDifferential, per supernode: df
  ::elasticity::NodeForceDifferentialArray<float, Space> residual;
  /// z
  /// elasticity::NodeDisplacement, per supernode: dx
  ::elasticity::NodeDisplacementArray<float, Space> correction;
  /// quasistatic::SchwarzFactor, per factor: W
  ::quasistatic::SchwarzFactorArray<float, Space> factors;

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

  /// Of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return nodes.bytes(
        ) + slots.bytes() + blocks.bytes() + supernode_term_ranges.bytes() + supernode_term_entries.bytes() +
            pair_term_ranges.bytes() + pair_term_entries.bytes() + block_edge_ranges.bytes() +
                block_edge_entries.bytes() + supernodes.bytes() + pair_stiffness.bytes() + residual.bytes() +
                    correction.bytes() + factors.bytes();
  }
};

template <class Space_ = physgen::Host>
struct Planes {
  using Space = Space_;
  using Real = float;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t plane = 0;
    physgen::index_t surface_node = 0;
    physgen::index_t node = 0;
    physgen::index_t contact = 0;
  };

  /// contact::RigidPlane, per plane: normal, offset, travel
  physgen::ReadOnlyArray<::contact::RigidPlaneArray<double, Space>> planes;
  /// None where equilibrium is not solved.
  /// contact::NodeArea, per surface_node: area
  physgen::ReadOnlyArray<::contact::NodeAreaArray<double, Space>> areas;
  /// The part of the nodes' blocks that planes have.
  /// elasticity::NodeStiffness, per node: K
  ::elasticity::NodeStiffnessArray<float, Space> stiffness;
  /// How one plane and the body touch, where equilibrium is solved.
  /// contact::PlaneContact, per contact: force, depth
  ::contact::PlaneContactArray<double, Space> contact;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(planes, counts.plane);
    physgen::allocate(areas, counts.surface_node);
    physgen::allocate(stiffness, counts.node, {"K"});
    physgen::allocate(contact, counts.contact, {"force", "depth"});
  }

  /// Of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return planes.bytes() + areas.bytes() + stiffness.bytes() + contact.bytes();
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

template <class Space_ = physgen::Host>
struct Stresses {
  using Space = Space_;
  using Real = float;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t tet = 0;
  };

  /// elasticity::Stress, per tet: P
  ::elasticity::StressArray<double, Space> of_tets;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(of_tets, counts.tet, {"P"});
  }

  /// Of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const { return of_tets.bytes(); }
};

}  // namespace scenes::everything_scene
