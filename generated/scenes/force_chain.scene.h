// Arrays of the scene force_chain, with the fields that its program needs. Written by physgen from scenes/force_chain.h
// and the kernels that it runs: change these, not this file.
#pragma once

#include <physgen/arrays/local_array.h>
#include <physgen/scenes/scene_arrays.h>

#include <elasticity.physgen.h>

namespace scenes { struct force_chain; }

/// Elastic forces of a Neo-Hookean body: from the positions of its nodes to the force on each.
namespace scenes::force_chain_scene {

namespace tags::body {
struct positions { static constexpr const char* name = "body.positions"; };
struct tets { static constexpr const char* name = "body.tets"; };
struct rest { static constexpr const char* name = "body.rest"; };
struct node_ranges { static constexpr const char* name = "body.node_ranges"; };
struct node_tets { static constexpr const char* name = "body.node_tets"; };
struct gradients { static constexpr const char* name = "body.gradients"; };
struct svds { static constexpr const char* name = "body.svds"; };
struct stresses { static constexpr const char* name = "body.stresses"; };
struct corner_forces { static constexpr const char* name = "body.corner_forces"; };
struct forces { static constexpr const char* name = "body.forces"; };
}  // namespace tags::body

template <class Space_ = physgen::Host, class Real_ = float, class Stored_ = physgen::StoredAsDeclared>
struct Body {
  using Space = Space_;
  using Real = Real_;
  using Stored = Stored_;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t node = 0;
    physgen::index_t tet = 0;
    physgen::index_t corner = 0;
  };

  /// The nodes that move, and where they were at rest.
  /// elasticity::NodePosition, per node: x
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::positions, ::elasticity::NodePositionArray<Real,
      Space>>> positions;
  /// elasticity::Tet, per tet: nodes
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::tets, ::elasticity::TetArray<Real, Space>>> tets;
  /// elasticity::RestShape, per tet: dm_inverse, volume
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::rest, ::elasticity::RestShapeArray<Real,
      Space>>> rest;
  /// The tets of each node: rows of (tet, corner).
  /// elasticity::IncidenceRange, per node: begin, end
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::node_ranges, ::elasticity::IncidenceRangeArray<Real,
      Space>>> node_ranges;
  /// elasticity::Incidence, per corner: element, local
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::node_tets, ::elasticity::IncidenceArray<Real,
      Space>>> node_tets;
  /// elasticity::DeformationGradient, per tet: F; local to steps that are one, so it holds no memory
  physgen::LocalArray<physgen::StoredArray<Stored, tags::body::gradients, ::elasticity::DeformationGradientArray<Real,
      Space>>, tags::body::gradients> gradients;
  /// elasticity::DeformationSvd, per tet: U, V, s; local to steps that are one, so it holds no memory
  physgen::LocalArray<physgen::StoredArray<Stored, tags::body::svds, ::elasticity::DeformationSvdArray<Real, Space>>,
      tags::body::svds> svds;
  /// elasticity::Stress, per tet: P; local to steps that are one, so it holds no memory
  physgen::LocalArray<physgen::StoredArray<Stored, tags::body::stresses, ::elasticity::StressArray<Real, Space>>,
      tags::body::stresses> stresses;
  /// elasticity::CornerForces, per tet: G
  physgen::StoredArray<Stored, tags::body::corner_forces, ::elasticity::CornerForcesArray<Real, Space>> corner_forces;
  /// elasticity::NodeForce, per node: f
  physgen::StoredArray<Stored, tags::body::forces, ::elasticity::NodeForceArray<Real, Space>> forces;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(positions, counts.node);
    physgen::allocate(tets, counts.tet);
    physgen::allocate(rest, counts.tet);
    physgen::allocate(node_ranges, counts.node);
    physgen::allocate(node_tets, counts.corner);
    physgen::allocate(gradients, counts.tet);
    physgen::allocate(svds, counts.tet);
    physgen::allocate(stresses, counts.tet);
    physgen::allocate(corner_forces, counts.tet, {"G"});
    physgen::allocate(forces, counts.node, {"f"});
  }

  /// Bytes of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return positions.bytes() + tets.bytes() + rest.bytes() + node_ranges.bytes() + node_tets.bytes() +
           gradients.bytes() + svds.bytes() + stresses.bytes() + corner_forces.bytes() + forces.bytes();
  }
  /// The same of arrays of so many objects, without making them. @pre no count is negative
  [[nodiscard]] static constexpr physgen::index_t bytes(const Counts& counts) {
    return physgen::bytes_of_array<decltype(positions)>(counts.node) +
           physgen::bytes_of_array<decltype(tets)>(counts.tet) + physgen::bytes_of_array<decltype(rest)>(counts.tet) +
           physgen::bytes_of_array<decltype(node_ranges)>(counts.node) +
           physgen::bytes_of_array<decltype(node_tets)>(counts.corner) +
           physgen::bytes_of_array<decltype(gradients)>(counts.tet) +
           physgen::bytes_of_array<decltype(svds)>(counts.tet) +
           physgen::bytes_of_array<decltype(stresses)>(counts.tet) +
           physgen::bytes_of_array<decltype(corner_forces)>(counts.tet) +
           physgen::bytes_of_array<decltype(forces)>(counts.node);
  }
};

}  // namespace scenes::force_chain_scene
