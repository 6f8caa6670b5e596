// The kernel checks on the CPU with floats (with doubles, in the other layouts: kernels_in_double_test.cpp); and that a
// SIMD pack computes what a single number does.
#include <physgen/parallel_for.h>

#include "kernel_checks.h"

namespace physgen::fem {
namespace {

template <class Real, class Layout, template <class> class Model>
using Case = KernelCase<Real, Host, Layout, Model>;
using Cases = testing::Types<Case<float, AosPadded, FixedCorotated>, Case<float, Soa, NeoHookean>,
                             Case<float, Aosoa<4>, FixedCorotated>, Case<float, Aosoa<16>, NeoHookean>>;
INSTANTIATE_TYPED_TEST_SUITE_P(HostInFloat, Kernels, Cases);

TEST(KernelsOverPacks, compute_what_they_compute_over_single_objects) {
  KernelScene<Case<float, Aosoa<16>, NeoHookean>> scene(5);
  const auto model = NeoHookean<float>::from(1, 0.45);
  scene.run_all(model);
  auto derivative = scene.derivative;
  auto differential = scene.stress_differential;
  parallel_for(Host{}, scene.elements(),
               lanes<1>(ComputeStressDerivative{model, scene.svd.const_view(), derivative.view()}));
  parallel_for(Host{}, scene.elements(),
               lanes<1>(ComputeStressDifferential{scene.svd.const_view(), derivative.const_view(),
                                                  scene.gradient_differential.const_view(), differential.view()}));
  for (index_t i = 0; i < scene.elements(); ++i) {
    const Eigen::Matrix3f a = differential.view()[i].dP(), b = scene.stress_differential.view()[i].dP();
    ASSERT_LE((a - b).norm(), 1e-5f * b.norm() + 1e-6f) << "tet " << i;
  }
}

TEST(KernelsOverRows, refuse_lists_of_other_sets) {
  KernelScene<Case<float, Aosoa<16>, NeoHookean>> scene(3);
  const auto expect_refused = [](const auto& make, const std::string& name) {
    try {
      make();
      FAIL() << name << " took rows of another set";
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  };
  const auto tets = scene.node_tets.const_view(), edges = scene.node_edges.const_view();
  const auto forces = scene.corner_forces.const_view();
  expect_refused([&] { GatherForces(edges, forces, scene.forces.view()); }, "GatherForces: node_tets");
  expect_refused([&] { GatherForceDifferentials(edges, forces, scene.matrix_free.view()); },
                 "GatherForceDifferentials: node_tets");
  const auto stiffness = scene.tet_stiffness.const_view();
  expect_refused([&] { GatherNodeStiffness(edges, stiffness, scene.node_stiffness.view()); },
                 "GatherNodeStiffness: node_tets");
  expect_refused([&] { GatherEdgeStiffness(tets, stiffness, scene.edge_stiffness.view()); },
                 "GatherEdgeStiffness: edge_tets");
  expect_refused(
      [&] {
        ComputeForceDifferentials(scene.node_stiffness.const_view(), scene.edge_stiffness.const_view(),
                                  scene.edges.const_view(), tets, scene.displacements.const_view(),
                                  scene.assembled.view());
      },
      "ComputeForceDifferentials: node_edges");
}

}  // namespace
}  // namespace physgen::fem
