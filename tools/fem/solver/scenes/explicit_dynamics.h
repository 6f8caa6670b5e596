// The scene explicit_dynamics: a time step of symplectic Euler of a Neo-Hookean body, and what is measured of it.
#pragma once

#include <dynamics.physgen.h>
#include <elasticity.physgen.h>
#include <fem/dynamics/explicit_steps.h>
#include <fem/materials/neo_hookean.h>
#include <physgen/scene.h>
#include <quasistatic.physgen.h>

namespace scenes {
using namespace physgen::scene;

/// Explicit dynamics of a Neo-Hookean body: one step of symplectic Euler with lumped mass, and the motion after it.
struct PHYSGEN_SCENE() explicit_dynamics {
  using Real = float;

  struct Body {
    PHYSGEN_ARRAY(per("tet"), input(), names("nodes", "node"), follows("node")) Array<elasticity::TetObject, Real> tets;
    PHYSGEN_ARRAY(per("tet"), input()) Array<elasticity::RestShapeObject, Real> rest;
    /// Where nodes gather: on the CPU.
    PHYSGEN_ARRAY(per("gathered_tet"), follows("node")) Array<elasticity::CornerForcesObject, Real> corners;
    /// Where forces are placed in the nodes' rows: on CUDA, in one process, if sums are to have the same bits on every
    /// run.
    PHYSGEN_ARRAY(per("placed_tet"), input(), names("places", "placed_corner"), follows("placed_corner"))
    Array<elasticity::TetPlacesObject, Real> places;
    PHYSGEN_ARRAY(per("placed_corner")) Array<elasticity::PlacedForceObject, Real> placed;

    /// The tets of each node: rows of (tet, corner). Where forces are placed the rows alone; where tets add, none.
    PHYSGEN_ARRAY(per("row"), input()) Array<elasticity::IncidenceRangeObject, float> node_tet_ranges;
    PHYSGEN_ARRAY(per("gathered_corner"), input(), names("element", "gathered_tet"), no_index("local"))
    Array<elasticity::IncidenceObject, float> node_tets;
    PHYSGEN_ARRAY(per("node"), input(), no_index("fixed")) Array<quasistatic::NodeConstraintObject, Real> constraints;
    PHYSGEN_ARRAY(per("node"), input()) Array<dynamics::NodeMassObject, double> masses;
    /// External forces, and the motion of prescribed components, at a load of 1.
    PHYSGEN_ARRAY(per("node"), input()) Array<elasticity::NodeForceObject, double> loads;
    PHYSGEN_ARRAY(per("node"), input()) Array<elasticity::NodeDisplacementObject, double> motion;
    /// From rest, and rounded to the precision of tets.
    PHYSGEN_ARRAY(per("node"), input(), output()) Array<elasticity::NodeDisplacementObject, double> displacements;
    PHYSGEN_ARRAY(per("node"), input(), output()) Array<elasticity::NodeDisplacementObject, Real> rounded;
    PHYSGEN_ARRAY(per("node"), input(), output()) Array<dynamics::NodeVelocityObject, double> velocities;
    /// Elastic.
    PHYSGEN_ARRAY(per("node")) Array<elasticity::NodeForceObject, Real> forces;
    /// Energies and momentum; the farthest coordinate stays what it is at the beginning.
    PHYSGEN_ARRAY(per(1), input("farthest"), output()) Array<dynamics::MotionObject, double> measured;
  };

  template <class On, class Body>
  static void program(On& on, Body& body, const physgen::fem::NeoHookean<Real>& material,
                      const physgen::fem::TimeStep& step) {
    physgen::fem::explicit_step(on, body, material, step);
    physgen::fem::measure_explicit_motion(on, body, material);
  }
};

}  // namespace scenes
