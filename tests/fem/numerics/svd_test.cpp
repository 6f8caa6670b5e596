// The checks of the SVD on the CPU: packs of all widths and single numbers.
#include <physgen/parallel_for.h>

#include "svd_parts_checks.h"

namespace physgen::fem {
namespace {

template <class Real, class Layout, int kLanes>
using Case = RunCase<Real, Host, Layout, kLanes>;
using Cases =
    testing::Types<Case<float, Aosoa<16>, 0>, Case<float, Aosoa<16>, 8>, Case<float, Soa, 4>, Case<float, Aos, 1>,
                   Case<double, Aosoa<16>, 0>, Case<double, Soa, 4>, Case<double, Aos, 1>>;
using PartCases = testing::Types<Case<float, Aosoa<16>, 0>, Case<double, Soa, 0>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Host, SvdOf, Cases);
INSTANTIATE_TYPED_TEST_SUITE_P(Host, SvdParts, PartCases);

struct CompactRotation : elasticity::ElementRotationFormats<Host> {
  using R = format::Quaternion16;
};
struct HalfStretches : elasticity::PrincipalStretchesFormats<Host> {
  using s = format::Half<>;
};

TEST(SvdOfArrays, takes_arrays_with_formats_of_their_own) {
  reference::Random random(21);
  elasticity::DeformationGradientArray<float> F(1003);
  for (index_t i = 0; i < F.size(); ++i) {
    F.view()[i].F() = reference::random_deformation(random).template cast<float>();
  }
  elasticity::ElementRotationArray<float> U(F.size()), V(F.size());
  elasticity::PrincipalStretchesArray<float> s(F.size());
  elasticity::ElementRotationArray<float, Host, Aosoa<16>, CompactRotation> compact_u(F.size()), compact_v(F.size());
  elasticity::PrincipalStretchesArray<float, Host, Aosoa<16>, HalfStretches> half(F.size());
  svd(F, U, s, V);
  svd(F, compact_u, half, compact_v);
  for (index_t i = 0; i < F.size(); ++i) {
    const auto error = [i](const auto& a, const auto& b) {
      return (a.view()[i].R().get() - b.view()[i].R().get()).cwiseAbs().template maxCoeff<Eigen::PropagateNaN>();
    };
    ASSERT_LE(error(U, compact_u), 2e-4F) << "matrix " << i;
    ASSERT_LE(error(V, compact_v), 2e-4F) << "matrix " << i;
    const auto exact = s.view()[i].s().get();
    ASSERT_LE((half.view()[i].s().get() - exact).cwiseAbs().maxCoeff(), 1e-3F * exact.cwiseAbs().maxCoeff());
  }
}

}  // namespace
}  // namespace physgen::fem
