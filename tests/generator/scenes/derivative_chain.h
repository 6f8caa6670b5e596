// A scene with everything that an array of a scene can be: kept, pruned, read-only, uniform and left out.
#pragma once

#include <elasticity.physgen.h>
#include <fem/kernels/compute_svd.h>
#include <fem/kernels/deformation_gradient.h>
#include <fem/kernels/stress_derivative.h>
#include <fem/materials/neo_hookean.h>
#include <physgen/scene.h>

namespace scenes {
using namespace physgen::scene;

/// Stress derivatives of a body whose tets have one rest shape.
struct PHYSGEN_SCENE() derivative_chain {
  using Real = float;

  /// The arrays of the body.
  struct Body {
    PHYSGEN_ARRAY(per("node"), input()) Array<elasticity::NodePositionObject, Real> positions;
    PHYSGEN_ARRAY(per("tet"), input()) Array<elasticity::TetObject, Real> tets;
    PHYSGEN_ARRAY(per("tet"), input("dm_inverse"), uniform()) Array<elasticity::RestShapeObject, Real> rest;
  };
  struct State {
    PHYSGEN_ARRAY(per("tet")) Array<elasticity::DeformationGradientObject, Real> gradients;
    PHYSGEN_ARRAY(per("tet")) Array<elasticity::DeformationSvdObject, Real> svds;  ///< only their stretches matter
    PHYSGEN_ARRAY(per("tet")) Array<elasticity::ElementRotationObject, Real> rotations;
    PHYSGEN_ARRAY(per("tet"), output()) Array<elasticity::PrincipalStretchesObject, Real> stretches;
    PHYSGEN_ARRAY(per("tet"), output("x1111", "x2121")) Array<elasticity::StressDerivativeObject, Real> derivatives;
  };

  template <class On, class Body, class State>
  static void program(On& on, Body& body, State& state, const physgen::fem::NeoHookean<Real>& material) {
    using namespace physgen::fem;
    const auto n = body.tets.size();
    const auto gradients = state.gradients.view();
    const auto svds = state.svds.view();
    on.run(n, ComputeDeformationGradient{body.tets.view(), body.positions.view(), body.rest.view(), gradients});
    on.run(n, ComputeSvd{gradients, svds});
    on.run(n, ComputeSvdParts{gradients, state.rotations.view(), state.stretches.view(), skip});
    on.run(n, ComputeStressDerivative{material, svds, state.derivatives.view()});
  }
};

}  // namespace scenes
