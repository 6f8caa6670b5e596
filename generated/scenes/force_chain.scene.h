// Arrays of the scene force_chain, with the fields that its program needs. Written by physgen from scenes/force_chain.h
// and the kernels that it runs: change these, not this file.
#pragma once

#include <physgen/scene_arrays.h>

#include "scenes/force_chain.h"

/// Elastic forces of a Neo-Hookean body: from the positions of its nodes to the force on each.
namespace scenes::force_chain_scene {

template <class Space_ = physgen::Host>
struct Body {
  using Space = Space_;
  using Real = float;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t node = 0;
    physgen::index_t tet = 0;
    physgen::index_t corner = 0;
  };

  /// What moves, and where it was at rest.
  /// elasticity::NodePosition, per node: x
  physgen::ReadOnlyArray<::elasticity::NodePositionArray<float, Space>> positions;
  /// elasticity::Tet, per tet: nodes
  physgen::ReadOnlyArray<::elasticity::TetArray<float, Space>> tets;
  /// elasticity::RestShape, per tet: dm_inverse, volume
  physgen::ReadOnlyArray<::elasticity::RestShapeArray<float, Space>> rest;
  /// The tets of each node: rows of (tet, corner).
  /// elasticity::IncidenceRange, per node: begin, end
  physgen::ReadOnlyArray<::elasticity::IncidenceRangeArray<float, Space>> node_ranges;
  /// elasticity::Incidence, per corner: element, local
  physgen::ReadOnlyArray<::elasticity::IncidenceArray<float, Space>> node_tets;
  /// elasticity::DeformationGradient, per tet: F
  ::elasticity::DeformationGradientArray<float, Space> gradients;
  /// elasticity::DeformationSvd, per tet: U, V, s
  ::elasticity::DeformationSvdArray<float, Space> svds;
  /// elasticity::Stress, per tet: P
  ::elasticity::StressArray<float, Space> stresses;
  /// elasticity::CornerForces, per tet: G
  ::elasticity::CornerForcesArray<float, Space> corner_forces;
  /// elasticity::NodeForce, per node: f
  ::elasticity::NodeForceArray<float, Space> forces;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(positions, counts.node);
    physgen::allocate(tets, counts.tet);
    physgen::allocate(rest, counts.tet);
    physgen::allocate(node_ranges, counts.node);
    physgen::allocate(node_tets, counts.corner);
    physgen::allocate(gradients, counts.tet, {"F"});
    physgen::allocate(svds, counts.tet, {"U", "V", "s"});
    physgen::allocate(stresses, counts.tet, {"P"});
    physgen::allocate(corner_forces, counts.tet, {"G"});
    physgen::allocate(forces, counts.node, {"f"});
  }

  /// Of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return positions.bytes(
        ) + tets.bytes() + rest.bytes() + node_ranges.bytes() + node_tets.bytes() + gradients.bytes() + svds.bytes() +
            stresses.bytes() + corner_forces.bytes() + forces.bytes();
  }
};

}  // namespace scenes::force_chain_scene
