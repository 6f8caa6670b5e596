// The scene force_chain: elastic forces of a Neo-Hookean body at given positions of its nodes.
#pragma once

#include <elasticity.physgen.h>
#include <fem/kernels/compute_svd.h>
#include <fem/kernels/deformation_gradient.h>
#include <fem/kernels/elastic_force.h>
#include <fem/kernels/stress.h>
#include <fem/materials/neo_hookean.h>
#include <physgen/scene.h>

namespace scenes {
using namespace physgen::scene;

/// Elastic forces of a Neo-Hookean body: from the positions of its nodes to the force on each.
struct PHYSGEN_SCENE() force_chain {
  using Real = float;

  struct Body {
    /// The nodes that move, and where they were at rest.
    PHYSGEN_ARRAY(per("node"), input()) Array<elasticity::NodePositionObject, Real> positions;
    PHYSGEN_ARRAY(per("tet"), input(), names("nodes", "node"), follows("node")) Array<elasticity::TetObject, Real> tets;
    PHYSGEN_ARRAY(per("tet"), input()) Array<elasticity::RestShapeObject, Real> rest;
    /// The tets of each node: rows of (tet, corner).
    PHYSGEN_ARRAY(per("node"), input()) Array<elasticity::IncidenceRangeObject, Real> node_ranges;
    PHYSGEN_ARRAY(per("corner"), input(), names("element", "tet")) Array<elasticity::IncidenceObject, Real> node_tets;

    PHYSGEN_ARRAY(per("tet")) Array<elasticity::DeformationGradientObject, Real> gradients;
    PHYSGEN_ARRAY(per("tet")) Array<elasticity::DeformationSvdObject, Real> svds;
    PHYSGEN_ARRAY(per("tet")) Array<elasticity::StressObject, Real> stresses;
    PHYSGEN_ARRAY(per("tet")) Array<elasticity::CornerForcesObject, Real> corner_forces;
    PHYSGEN_ARRAY(per("node"), output("f")) Array<elasticity::NodeForceObject, Real> forces;
  };

  template <class On, class Body>
  static void program(On& on, Body& body, const physgen::fem::LameParameters& lame) {
    using namespace physgen;
    using Scalar = typename Body::Real;
    const fem::NeoHookean<Scalar> material{Scalar(lame.mu), Scalar(lame.lambda)};
    const auto tets = body.tets.const_view();
    const auto rest = body.rest.const_view();
    const auto gradients = body.gradients.view();
    const auto svds = body.svds.view();
    const auto stresses = body.stresses.view();
    const auto corners = body.corner_forces.view();
    const index_t n = body.tets.size();
    on.run(n, fem::ComputeDeformationGradient{tets, body.positions.const_view(), rest, gradients});
    on.run(n, fem::ComputeSvd{gradients, svds});
    on.run(n, fem::ComputeStress{material, svds, stresses});
    on.run(n, fem::ComputeCornerForces{rest, stresses, corners});
    const Rows node_tets(body.node_ranges.const_view(), body.node_tets.const_view(), n);
    on.run(body.forces.size(), fem::GatherForces{node_tets, corners, body.forces.view()});
  }
};

}  // namespace scenes
