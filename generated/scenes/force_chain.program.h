// The program of the scene force_chain over its arrays: scenes::force_chain_scene::fused::program(on, ...). Written by
// physgen from scenes/force_chain.h: change that, not this file.
#pragma once

#include <physgen/fuse.h>

#include "scenes/force_chain.h"
#include "force_chain.scene.h"

namespace scenes::force_chain_scene {

/// The scene with a program in which steps are joined:
/// - ComputeDeformationGradient, ComputeSvd, ComputeStress and ComputeCornerForces; local to them: body.gradients,
/// body.svds and body.stresses
struct fused : ::scenes::force_chain {
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
    on.run(n, ::physgen::fuse(
        ::physgen::locals(body.gradients.view(), body.svds.view(), body.stresses.view()),
        fem::ComputeDeformationGradient{tets, body.positions.const_view(), rest, gradients},
        fem::ComputeSvd{gradients, svds},
        fem::ComputeStress{material, svds, stresses},
        fem::ComputeCornerForces{rest, stresses, corners}));
    const Rows node_tets(body.node_ranges.const_view(), body.node_tets.const_view(), n);
    on.run(body.forces.size(), fem::GatherForces{node_tets, corners, body.forces.view()});
  }
};

}  // namespace scenes::force_chain_scene
