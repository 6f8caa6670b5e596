// Arrays of the scene explicit_dynamics, with the fields that its program needs. Written by physgen from
// scenes/explicit_dynamics.h and the kernels that it runs: change these, not this file.
#pragma once

#include <physgen/scenes/scene_arrays.h>

#include <dynamics.physgen.h>
#include <elasticity.physgen.h>
#include <quasistatic.physgen.h>

namespace scenes { struct explicit_dynamics; }

/// Explicit dynamics of a Neo-Hookean body: one step of symplectic Euler with lumped mass, and the motion after it.
namespace scenes::explicit_dynamics_scene {

namespace tags::body {
struct tets { static constexpr const char* name = "body.tets"; };
struct rest { static constexpr const char* name = "body.rest"; };
struct corners { static constexpr const char* name = "body.corners"; };
struct places { static constexpr const char* name = "body.places"; };
struct placed { static constexpr const char* name = "body.placed"; };
struct node_tet_ranges { static constexpr const char* name = "body.node_tet_ranges"; };
struct node_tets { static constexpr const char* name = "body.node_tets"; };
struct constraints { static constexpr const char* name = "body.constraints"; };
struct masses { static constexpr const char* name = "body.masses"; };
struct loads { static constexpr const char* name = "body.loads"; };
struct motion { static constexpr const char* name = "body.motion"; };
struct displacements { static constexpr const char* name = "body.displacements"; };
struct rounded { static constexpr const char* name = "body.rounded"; };
struct velocities { static constexpr const char* name = "body.velocities"; };
struct forces { static constexpr const char* name = "body.forces"; };
struct measured { static constexpr const char* name = "body.measured"; };
}  // namespace tags::body

template <class Space_ = physgen::Host, class Real_ = float, class Stored_ = physgen::StoredAsDeclared>
struct Body {
  using Space = Space_;
  using Real = Real_;
  using Stored = Stored_;

  /// How many objects there are of each kind.
  struct Counts {
    physgen::index_t tet = 0;
    physgen::index_t gathered_tet = 0;
    physgen::index_t placed_tet = 0;
    physgen::index_t placed_corner = 0;
    physgen::index_t row = 0;
    physgen::index_t gathered_corner = 0;
    physgen::index_t node = 0;
  };

  /// elasticity::Tet, per tet: nodes
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::tets, ::elasticity::TetArray<Real, Space>>> tets;
  /// elasticity::RestShape, per tet: dm_inverse, volume
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::rest, ::elasticity::RestShapeArray<Real,
      Space>>> rest;
  /// Where nodes gather: on the CPU.
  /// elasticity::CornerForces, per gathered_tet: G
  physgen::StoredArray<Stored, tags::body::corners, ::elasticity::CornerForcesArray<Real, Space>> corners;
  /// Where forces are placed in the nodes' rows: on CUDA, in one process, if sums are to have the same bits on every
  /// run.
  /// elasticity::TetPlaces, per placed_tet: places
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::places, ::elasticity::TetPlacesArray<Real,
      Space>>> places;
  /// elasticity::PlacedForce, per placed_corner: f
  physgen::StoredArray<Stored, tags::body::placed, ::elasticity::PlacedForceArray<Real, Space>> placed;
  /// The tets of each node: rows of (tet, corner). Where forces are placed the rows alone; where tets add, none.
  /// elasticity::IncidenceRange, per row: begin, end
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::node_tet_ranges,
      ::elasticity::IncidenceRangeArray<float, Space>>> node_tet_ranges;
  /// elasticity::Incidence, per gathered_corner: element, local
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::node_tets, ::elasticity::IncidenceArray<float,
      Space>>> node_tets;
  /// quasistatic::NodeConstraint, per node: fixed
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::constraints, ::quasistatic::NodeConstraintArray<Real,
      Space>>> constraints;
  /// dynamics::NodeMass, per node: mass
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::masses, ::dynamics::NodeMassArray<double,
      Space>>> masses;
  /// External forces, and the motion of prescribed components, at a load of 1.
  /// elasticity::NodeForce, per node: f
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::loads, ::elasticity::NodeForceArray<double,
      Space>>> loads;
  /// elasticity::NodeDisplacement, per node: dx
  physgen::ReadOnlyArray<physgen::StoredArray<Stored, tags::body::motion, ::elasticity::NodeDisplacementArray<double,
      Space>>> motion;
  /// From rest, and rounded to the precision of tets.
  /// elasticity::NodeDisplacement, per node: dx
  physgen::StoredArray<Stored, tags::body::displacements, ::elasticity::NodeDisplacementArray<double,
      Space>> displacements;
  /// elasticity::NodeDisplacement, per node: dx
  physgen::StoredArray<Stored, tags::body::rounded, ::elasticity::NodeDisplacementArray<Real, Space>> rounded;
  /// dynamics::NodeVelocity, per node: v
  physgen::StoredArray<Stored, tags::body::velocities, ::dynamics::NodeVelocityArray<double, Space>> velocities;
  /// Elastic.
  /// elasticity::NodeForce, per node: f
  physgen::StoredArray<Stored, tags::body::forces, ::elasticity::NodeForceArray<Real, Space>> forces;
  /// Energies and momentum; the farthest coordinate stays what it is at the beginning.
  /// dynamics::Motion, 1 object: kinetic, momentum, elastic, farthest
  physgen::StoredArray<Stored, tags::body::measured, ::dynamics::MotionArray<double, Space>> measured;

  /// Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the program
  /// writes before it reads them begin as signalling NaN instead.
  /// @throw physgen::Error when a count is negative or the memory cannot be had
  void allocate(const Counts& counts) {
    physgen::allocate(tets, counts.tet);
    physgen::allocate(rest, counts.tet);
    physgen::allocate(corners, counts.gathered_tet, {"G"});
    physgen::allocate(places, counts.placed_tet);
    physgen::allocate(placed, counts.placed_corner, {"f"});
    physgen::allocate(node_tet_ranges, counts.row);
    physgen::allocate(node_tets, counts.gathered_corner);
    physgen::allocate(constraints, counts.node);
    physgen::allocate(masses, counts.node);
    physgen::allocate(loads, counts.node);
    physgen::allocate(motion, counts.node);
    physgen::allocate(displacements, counts.node);
    physgen::allocate(rounded, counts.node);
    physgen::allocate(velocities, counts.node);
    physgen::allocate(forces, counts.node, {"f"});
    physgen::allocate(measured, 1, {"kinetic", "momentum", "elastic"});
  }

  /// Bytes of memory held by all arrays, padding included.
  [[nodiscard]] physgen::index_t bytes() const {
    return tets.bytes() + rest.bytes() + corners.bytes() + places.bytes() + placed.bytes() + node_tet_ranges.bytes() +
           node_tets.bytes() + constraints.bytes() + masses.bytes() + loads.bytes() + motion.bytes() +
           displacements.bytes() + rounded.bytes() + velocities.bytes() + forces.bytes() + measured.bytes();
  }
  /// The same of arrays of so many objects, without making them. @pre no count is negative
  [[nodiscard]] static constexpr physgen::index_t bytes(const Counts& counts) {
    return physgen::bytes_of_array<decltype(tets)>(counts.tet) + physgen::bytes_of_array<decltype(rest)>(counts.tet) +
           physgen::bytes_of_array<decltype(corners)>(counts.gathered_tet) +
           physgen::bytes_of_array<decltype(places)>(counts.placed_tet) +
           physgen::bytes_of_array<decltype(placed)>(counts.placed_corner) +
           physgen::bytes_of_array<decltype(node_tet_ranges)>(counts.row) +
           physgen::bytes_of_array<decltype(node_tets)>(counts.gathered_corner) +
           physgen::bytes_of_array<decltype(constraints)>(counts.node) +
           physgen::bytes_of_array<decltype(masses)>(counts.node) +
           physgen::bytes_of_array<decltype(loads)>(counts.node) +
           physgen::bytes_of_array<decltype(motion)>(counts.node) +
           physgen::bytes_of_array<decltype(displacements)>(counts.node) +
           physgen::bytes_of_array<decltype(rounded)>(counts.node) +
           physgen::bytes_of_array<decltype(velocities)>(counts.node) +
           physgen::bytes_of_array<decltype(forces)>(counts.node) + physgen::bytes_of_array<decltype(measured)>(1);
  }
};

}  // namespace scenes::explicit_dynamics_scene
