// Arrays of the scene explicit_dynamics, with the fields that its program needs. Written by physgen from
// scenes/explicit_dynamics.h and the kernels that it runs: change these, not this file.
#pragma once

#include <physgen/scene_arrays.h>

#include "scenes/explicit_dynamics.h"

/// Explicit dynamics of a Neo-Hookean body: one step of symplectic Euler with lumped mass.
namespace scenes::explicit_dynamics_scene {

template <class Space_ = physgen::Host>
struct Body {
  using Space = Space_;
  using Real = float;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t tet = 0;
    physgen::index_t node = 0;
    physgen::index_t corner = 0;
  };

  /// elasticity::Tet, per tet: nodes
  physgen::ReadOnlyArray<::elasticity::TetArray<float, Space>> tets;
  /// elasticity::RestShape, per tet: dm_inverse, volume
  physgen::ReadOnlyArray<::elasticity::RestShapeArray<float, Space>> rest;
  /// elasticity::CornerForces, per tet: G
  ::elasticity::CornerForcesArray<float, Space> corners;
  /// The tets of each node: rows of (tet, corner).
  /// elasticity::IncidenceRange, per node: begin, end
  physgen::ReadOnlyArray<::elasticity::IncidenceRangeArray<float, Space>> node_tet_ranges;
  /// elasticity::Incidence, per corner: element, local
  physgen::ReadOnlyArray<::elasticity::IncidenceArray<float, Space>> node_tets;
  /// quasistatic::NodeConstraint, per node: fixed
  physgen::ReadOnlyArray<::quasistatic::NodeConstraintArray<float, Space>> constraints;
  /// dynamics::NodeMass, per node: mass
  physgen::ReadOnlyArray<::dynamics::NodeMassArray<double, Space>> masses;
  /// External forces, and the motion of prescribed components, at a load of 1.
  /// elasticity::NodeForce, per node: f
  physgen::ReadOnlyArray<::elasticity::NodeForceArray<double, Space>> loads;
  /// elasticity::NodeDisplacement, per node: dx
  physgen::ReadOnlyArray<::elasticity::NodeDisplacementArray<double, Space>> motion;
  /// From rest, and rounded to the precision of tets.
  /// elasticity::NodeDisplacement, per node: dx
  ::elasticity::NodeDisplacementArray<double, Space> displacements;
  /// elasticity::NodeDisplacement, per node: dx
  ::elasticity::NodeDisplacementArray<float, Space> rounded;
  /// dynamics::NodeVelocity, per node: v
  ::dynamics::NodeVelocityArray<double, Space> velocities;
  /// elasticity::NodeForce, per node: f
  ::elasticity::NodeForceArray<float, Space> forces;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(tets, counts.tet);
    physgen::allocate(rest, counts.tet);
    physgen::allocate(corners, counts.tet, {"G"});
    physgen::allocate(node_tet_ranges, counts.node);
    physgen::allocate(node_tets, counts.corner);
    physgen::allocate(constraints, counts.node);
    physgen::allocate(masses, counts.node);
    physgen::allocate(loads, counts.node);
    physgen::allocate(motion, counts.node);
    physgen::allocate(displacements, counts.node);
    physgen::allocate(rounded, counts.node);
    physgen::allocate(velocities, counts.node);
    physgen::allocate(forces, counts.node, {"f"});
  }

  /// Of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return tets.bytes(
        ) + rest.bytes() + corners.bytes() + node_tet_ranges.bytes() + node_tets.bytes() + constraints.bytes() +
            masses.bytes() + loads.bytes() + motion.bytes() + displacements.bytes() + rounded.bytes() +
                velocities.bytes() + forces.bytes();
  }
};

}  // namespace scenes::explicit_dynamics_scene
