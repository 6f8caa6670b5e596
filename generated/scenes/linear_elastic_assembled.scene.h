// Arrays of the scene linear_elastic_assembled, with the fields that its program needs. Written by physgen from
// scenes/linear_elastic_assembled.h and the kernels that it runs: change these, not this file.
#pragma once

#include <physgen/scenes/scene_arrays.h>

#include <elasticity.physgen.h>
#include <quasistatic.physgen.h>

namespace scenes { struct linear_elastic_assembled; }

/// Linear elasticity: an equilibrium by conjugate gradients with assembled stiffness, and each preconditioner that
/// there is for it, on meshes and background grids, stored as computed or in half.
namespace scenes::linear_elastic_assembled_scene {

namespace tags::linear {
struct tets { static constexpr const char* name = "linear.tets"; };
struct rest { static constexpr const char* name = "linear.rest"; };
struct node_tet_ranges { static constexpr const char* name = "linear.node_tet_ranges"; };
struct node_tets { static constexpr const char* name = "linear.node_tets"; };
struct edge_tet_ranges { static constexpr const char* name = "linear.edge_tet_ranges"; };
struct edge_tets { static constexpr const char* name = "linear.edge_tets"; };
struct displacements { static constexpr const char* name = "linear.displacements"; };
struct motion { static constexpr const char* name = "linear.motion"; };
struct loads { static constexpr const char* name = "linear.loads"; };
struct forces { static constexpr const char* name = "linear.forces"; };
struct state { static constexpr const char* name = "linear.state"; };
}  // namespace tags::linear

template <class Space_ = physgen::Host, class Real_ = float, class Stored_ = physgen::StoredAsDeclared>
struct Linear {
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
  };

  /// elasticity::Tet, per tet: nodes
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::linear::tets, ::elasticity::TetArray<Real, Space>>> tets;
  /// elasticity::RestShape, per tet: dm_inverse, volume
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::linear::rest, ::elasticity::RestShapeArray<double,
      Space>>> rest;
  /// The tets of each node: rows of NodeTetEntry.
  /// elasticity::IncidenceRange, per node: begin, end
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::linear::node_tet_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>> node_tet_ranges;
  /// quasistatic::PackedIncidence, per corner: code
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::linear::node_tets,
      ::quasistatic::PackedIncidenceArray<float, Space>>> node_tets;
  /// The tets of each edge: rows of EdgeTetEntry. None where the stiffness is not assembled.
  /// elasticity::IncidenceRange, per edge: begin, end
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::linear::edge_tet_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>> edge_tet_ranges;
  /// quasistatic::PackedIncidence, per tet_edge: code
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::linear::edge_tets,
      ::quasistatic::PackedIncidenceArray<float, Space>>> edge_tets;
  /// u, from rest.
  /// elasticity::NodeDisplacement, per node: dx
  physgen::StoredArray<Stored, tags::linear::displacements, ::elasticity::NodeDisplacementArray<double,
      Space>> displacements;
  /// The motion of prescribed components, at a load of 1.
  /// elasticity::NodeDisplacement, per node: dx
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::linear::motion, ::elasticity::NodeDisplacementArray<double,
      Space>>> motion;
  /// External, at a load of 1.
  /// elasticity::NodeForce, per node: f
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::linear::loads, ::elasticity::NodeForceArray<double,
      Space>>> loads;
  /// Elastic and external; in prescribed components minus the reaction.
  /// elasticity::NodeForce, per node: f
  physgen::StoredArray<Stored, tags::linear::forces, ::elasticity::NodeForceArray<double, Space>> forces;
  /// Its volumetric energy and its work stay 0.
  /// quasistatic::Equilibrium, 1 object: elastic, volumetric, loads, free_square, fixed_square, work, smallest_ratio
  physgen::StoredArray<Stored, tags::linear::state, ::quasistatic::EquilibriumArray<double, Space>> state;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(tets, counts.tet);
    physgen::allocate(rest, counts.tet);
    physgen::allocate(node_tet_ranges, counts.node);
    physgen::allocate(node_tets, counts.corner);
    physgen::allocate(edge_tet_ranges, counts.edge);
    physgen::allocate(edge_tets, counts.tet_edge);
    physgen::allocate(displacements, counts.node, {"dx"});
    physgen::allocate(motion, counts.node);
    physgen::allocate(loads, counts.node);
    physgen::allocate(forces, counts.node, {"f"});
    physgen::allocate(state, 1, {"elastic", "loads", "free_square", "fixed_square", "smallest_ratio"});
  }

  /// Bytes of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return tets.bytes() + rest.bytes() + node_tet_ranges.bytes() + node_tets.bytes() + edge_tet_ranges.bytes() +
           edge_tets.bytes() + displacements.bytes() + motion.bytes() + loads.bytes() + forces.bytes() + state.bytes();
  }
  /// The same of arrays of so many objects, without making them. @pre no count is negative
  [[nodiscard]] static constexpr physgen::index_t bytes(const Counts& counts) {
    return physgen::bytes_of_array<decltype(tets)>(counts.tet) + physgen::bytes_of_array<decltype(rest)>(counts.tet) +
           physgen::bytes_of_array<decltype(node_tet_ranges)>(counts.node) +
           physgen::bytes_of_array<decltype(node_tets)>(counts.corner) +
           physgen::bytes_of_array<decltype(edge_tet_ranges)>(counts.edge) +
           physgen::bytes_of_array<decltype(edge_tets)>(counts.tet_edge) +
           physgen::bytes_of_array<decltype(displacements)>(counts.node) +
           physgen::bytes_of_array<decltype(motion)>(counts.node) +
           physgen::bytes_of_array<decltype(loads)>(counts.node) +
           physgen::bytes_of_array<decltype(forces)>(counts.node) + physgen::bytes_of_array<decltype(state)>(1);
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

}  // namespace scenes::linear_elastic_assembled_scene
