// The kernel checks on the CPU, in all layouts; and that a SIMD pack computes what a single number does.
#include <physgen/parallel_for.h>

#include "kernel_checks.h"

namespace physgen::fem {
namespace {

template <class Real, class Layout, template <class> class Model>
using Case = KernelCase<Real, Host, Layout, Model>;
using Cases = testing::Types<Case<float, Aos, NeoHookean>, Case<float, AosPadded, FixedCorotated>,
                             Case<float, Soa, NeoHookean>, Case<float, Aosoa<4>, FixedCorotated>,
                             Case<float, Aosoa<16>, NeoHookean>, Case<float, Aosoa<32>, FixedCorotated>,
                             Case<double, Aos, FixedCorotated>, Case<double, AosPadded, NeoHookean>,
                             Case<double, Soa, FixedCorotated>, Case<double, Aosoa<16>, NeoHookean>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Host, Kernels, Cases);

TEST(KernelsOverPacks, compute_what_they_compute_over_single_objects) {
  KernelScene<Case<float, Aosoa<16>, NeoHookean>> scene(5);
  const auto model = NeoHookean<float>::from(1, 0.45);
  scene.run_all(model);
  auto derivative = scene.derivative;
  auto differential = scene.stress_differential;
  parallel_for<1>(Host{}, scene.elements(), ComputeStressDerivative{model, scene.svd.const_view(), derivative.view()});
  parallel_for<1>(Host{}, scene.elements(),
                  DpFromDf{scene.svd.const_view(), derivative.const_view(), scene.gradient_differential.const_view(),
                           differential.view()});
  for (index_t i = 0; i < scene.elements(); ++i) {
    const Eigen::Matrix3f a = differential.view()[i].dP(), b = scene.stress_differential.view()[i].dP();
    ASSERT_LE((a - b).norm(), 1e-5f * b.norm() + 1e-6f) << "tet " << i;
  }
}

}  // namespace
}  // namespace physgen::fem
