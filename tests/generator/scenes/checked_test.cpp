// Programs of scenes in checked builds. This program is compiled with PHYSGEN_CHECKED.
#include <physgen/executor.h>

#include "force_chain_case.h"

namespace physgen::test::force_chain {
namespace {

/// The scene force_chain with its tets' kernels as one step, of which the kernel of stresses is the first: it reads
/// svds, which is local to the step, before the kernel that writes it.
struct stress_too_early : scenes::force_chain {
  template <class On, class Body>
  static void program(On& on, Body& body, const fem::LameParameters& lame) {
    using Scalar = typename Body::Real;
    const fem::NeoHookean<Scalar> material{Scalar(lame.mu), Scalar(lame.lambda)};
    const auto tets = body.tets.const_view();
    const auto rest = body.rest.const_view();
    on.run(body.tets.size(),
           fuse(locals(body.gradients.view(), body.svds.view(), body.stresses.view()),
                fem::ComputeStress{material, body.svds.view(), body.stresses.view()},
                fem::ComputeDeformationGradient{tets, body.positions.const_view(), rest, body.gradients.view()},
                fem::ComputeSvd{body.gradients.view(), body.svds.view()},
                fem::ComputeCornerForces{rest, body.stresses.view(), body.corner_forces.view()}));
  }
};

/// How many of the numbers in corner forces are none after the program, whose arrays are the scene's.
template <class Program, class Real>
index_t count_nan() {
  scenes::force_chain_scene::Body<Host, Real> body;
  body.allocate({.node = nodes, .tet = tets, .corner = 4 * tets});
  Plain<Real, Host> given;
  fill<Real>(given);
  give(body, given, [](auto& array) -> auto& { return array.contents(); });
  HostExecutor on;
  Program::program(on, body, lame);
  index_t count = 0;
  for (index_t t = 0; t < tets; ++t)
    for (int k = 0; k < 9; ++k) count += std::isnan(body.corner_forces.view()[t].G()[k]) ? 1 : 0;
  return count;
}

TEST(CheckedScene, has_nan_where_a_step_reads_what_is_local_to_it_before_it_is_written) {
  static_assert(checked_build);
  EXPECT_EQ((count_nan<stress_too_early, float>()), 9 * tets);
  EXPECT_EQ((count_nan<stress_too_early, double>()), 9 * tets);
  EXPECT_EQ((count_nan<scenes::force_chain_scene::fused, float>()), 0);
  EXPECT_EQ((count_nan<scenes::force_chain_scene::fused, double>()), 0);
}

}  // namespace
}  // namespace physgen::test::force_chain
