// The scene linear_elastic: an equilibrium for small strain.
#pragma once

#include <elasticity.physgen.h>
#include <fem/solver/linear_steps.h>
#include <physgen/scene.h>
#include <quasistatic.physgen.h>

namespace scenes {
using namespace physgen::scene;

/// Linear elasticity: an equilibrium by conjugate gradients without blocks of edges, preconditioned by the inverses of
/// nodes' blocks.
struct PHYSGEN_SCENE() linear_elastic {
  using Real = float;

  struct Body {
    PHYSGEN_ARRAY(per("tet"), input()) Array<elasticity::TetObject, Real> tets;
    PHYSGEN_ARRAY(per("tet"), input()) Array<elasticity::RestShapeObject, double> rest;
    /// The tets of each node: rows of a tet and a corner in one number.
    PHYSGEN_ARRAY(per("node"), input()) Array<elasticity::IncidenceRangeObject, float> node_tet_ranges;
    PHYSGEN_ARRAY(per("corner"), input()) Array<quasistatic::PackedIncidenceObject, float> node_tets;
    /// External forces, and the motion of prescribed components, at a load of 1.
    PHYSGEN_ARRAY(per("node"), input()) Array<elasticity::NodeForceObject, double> loads;
    PHYSGEN_ARRAY(per("node"), input()) Array<elasticity::NodeDisplacementObject, double> motion;
    /// From rest.
    PHYSGEN_ARRAY(per("node"), output()) Array<elasticity::NodeDisplacementObject, double> displacements;
    PHYSGEN_ARRAY(per("node")) Array<elasticity::NodeForceObject, double> forces;
    /// Before the solve.
    PHYSGEN_ARRAY(per(1), output("elastic", "loads", "free_square", "fixed_square"))
    Array<quasistatic::EquilibriumObject, double> state;
  };
  /// The preconditioner, in unknowns scaled to a unit diagonal.
  struct Level {
    PHYSGEN_ARRAY(per("node"), input()) Array<quasistatic::NodeConstraintObject, Real> constraints;
    PHYSGEN_ARRAY(per("node")) Array<quasistatic::NodeScaleObject, Real> scales;
    PHYSGEN_ARRAY(per("node")) Array<elasticity::NodeStiffnessObject, Real> node_stiffness;
    PHYSGEN_ARRAY(per("node")) Array<quasistatic::NodeInverseObject, Real> inverse;
    PHYSGEN_ARRAY(per("node")) Array<elasticity::NodeForceDifferentialObject, Real> residual;
    PHYSGEN_ARRAY(per("node")) Array<elasticity::NodeDisplacementObject, Real> correction;
  };
  /// Conjugate gradients.
  struct Vectors {
    PHYSGEN_ARRAY(per("node")) Array<elasticity::NodeDisplacementObject, Real> step;
    PHYSGEN_ARRAY(per("node")) Array<elasticity::NodeForceDifferentialObject, Real> residual;
    PHYSGEN_ARRAY(per("node")) Array<elasticity::NodeDisplacementObject, Real> direction;
    PHYSGEN_ARRAY(per("node")) Array<elasticity::NodeForceDifferentialObject, Real> product;
    PHYSGEN_ARRAY(per(1), output()) Array<quasistatic::LinearSolveObject, double> state;
  };

  template <class On, class Body, class Level, class Vectors>
  static void program(On& on, Body& body, Level& level, Vectors& vectors, const physgen::fem::LameParameters& lame,
                      double load, double tolerance, int most_iterations) {
    using namespace physgen::fem;
    on.run(body.displacements.size(),
           BeginAtLoad{load, body.motion.const_view(), level.constraints.const_view(), body.displacements.view()});
    evaluate_linear(on, body, level, lame, load);
    prepare_linear_nodes(on, body, level, lame);
    typename On::Loop loop;
    solve_linear_matrix_free(on, loop, body, level, vectors, lame, true, tolerance, most_iterations);
  }
};

}  // namespace scenes
