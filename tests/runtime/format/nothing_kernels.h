// Kernels over arrays that prune fields, run by the caller on the host or on the device.
#pragma once

#include <fem/kernels/compute_svd.h>
#include <fem/kernels/stress_derivative.h>
#include <fem/materials/neo_hookean.h>

#include "nothing_checks.h"

namespace physgen::test {

/// Every word that only writes.
template <class SvdView, class DerivativeView, class EntriesView>
struct StoreSomeFields {
  using Scalar = float;
  SvdView svds;
  DerivativeView derivatives;
  EntriesView entries;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<float, I>;
    const auto svd = svds[i];
    svd.U() = Eigen::Matrix<S, 3, 3>::Constant(S(4.0F));
    svd.U().setIdentity();
    svd.V()[5] = S(3.0F);
    svd.V()(1, 2) = S(2.0F);
    store_where(S(1.0F) > S(0.0F), svd.V(), Eigen::Matrix<S, 3, 3>::Constant(S(1.0F)));
    derivatives[i].x1111() = S(1e30F);
    store_where(S(1.0F) > S(0.0F), derivatives[i].x2222(), S(1e30F));
    entries[i].weights(2) = S(5.0F);
    svd.s() = Eigen::Matrix<S, 3, 1>::Constant(S(6.0F));
  }
};

/// The stress derivatives of deformation gradients, by way of SVDs in these formats.
/// @param run run(n, kernel) runs it over n objects in Space
template <class Space, class Layout, class Formats, class Real, class Run>
auto derivatives_through(const elasticity::DeformationGradientArray<Real, Space, Aos>& F, const Run& run) {
  Array<elasticity::DeformationSvdObject, Real, Space, Layout, Formats> svds(F.size());
  elasticity::StressDerivativeArray<Real, Space, Aos> derivatives(F.size());
  const fem::NeoHookean<Real> model{Real(1e5), Real(4e5)};
  run(F.size(), fem::ComputeSvd{F.const_view(), svds.view()});
  run(F.size(), fem::ComputeStressDerivative{model, svds.const_view(), derivatives.view()});
  elasticity::StressDerivativeArray<Real, Host, Aos> results(F.size());
  poison(results);
  copy(results, derivatives);
  synchronize();
  return results;
}

/// Kernels that read the stretches alone give the same bits where these alone are stored.
template <class Real, class Space, class Layout, class Run>
void check_results_with_pruned_rotations(const Run& run) {
  std::mt19937 random(seed());
  std::uniform_real_distribution<double> entry(-0.3, 0.3);
  elasticity::DeformationGradientArray<Real, Host, Aos> F(1003);
  for (index_t i = 0; i < F.size(); ++i) {
    for (int k = 0; k < 9; ++k) F.putdata(i, k, entry(random) + (k % 4 == 0 ? 1 : 0));
  }
  elasticity::DeformationGradientArray<Real, Space, Aos> there(F.size());
  copy(there, F);
  const auto all = derivatives_through<Space, Layout, elasticity::DeformationSvdFormats<Host>>(there, run);
  const auto part = derivatives_through<Space, Layout, StretchesOnly>(there, run);
  EXPECT_EQ(count_different(all, part), 0);
  EXPECT_NE(all.getdata(0, 0), all.getdata(1002, 0)) << "of random objects";
}

}  // namespace physgen::test
