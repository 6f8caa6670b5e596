// The eigenvalue filters on the stress derivatives of every material, and the kernel that applies them.
#include <elasticity.physgen.h>
#include <fem/kernels/stress_derivative.h>
#include <physgen/parallel_for.h>

#include "definiteness_checks.h"

namespace physgen::fem {
namespace {

template <class Model>
class DefinitenessOfMaterial : public testing::Test {};
TYPED_TEST_SUITE(DefinitenessOfMaterial, MaterialTypes<double>);
template <class Model>
class DefinitenessOfMaterialInFloat : public testing::Test {};
TYPED_TEST_SUITE(DefinitenessOfMaterialInFloat, MaterialTypes<float>);

template <class Model>
void check_filters() {
  using Real = typename Model::Scalar;
  Random random(24);
  for (const Elasticity& constants : tested_constants) {
    const auto m = model_of<Model>(constants);
    WorstInput<3> worst;
    for (int k = 0; k < 2000; ++k) {
      const Vector3<double> s = k % 2 == 0 ? random_stretch(random) : compressed_stretch(random);
      const auto d = m.derivative(Vector3<Real>(s.cast<Real>()));
      const FilterErrors e = filter_errors(d);
      worst.add(e.largest(), {double(Real(s[0])), double(Real(s[1])), double(Real(s[2]))});
      for (const auto& filtered : {ClampEigenvalues{}(d), AbsoluteEigenvalues{}(d)}) {
        const auto all = entries(filtered);
        for (std::size_t i = 6; i < 12; ++i) EXPECT_GE(all[i], 0) << m.name << " " << hexadecimal(s);
      }
    }
    EXPECT_LE(worst.error(), 8) << m.name << ", nu " << constants.nu << ", at " << worst.replay("PHYSGEN_TEST_STRETCH");
  }
}

TYPED_TEST(DefinitenessOfMaterial, holds_for_compressed_stretched_and_inverted_elements) { check_filters<TypeParam>(); }
TYPED_TEST(DefinitenessOfMaterialInFloat, holds_for_compressed_stretched_and_inverted_elements) {
  check_filters<TypeParam>();
}

TEST(ComputeStressDerivative, writes_what_its_filter_makes_of_the_derivative) {
  const auto m = NeoHookean<double>::from(1e4, 0.45);
  Random random(25);
  Array<elasticity::DeformationSvdObject, double, Host, Aosoa<16>> svd(37);
  Array<elasticity::StressDerivativeObject, double, Host, Aosoa<16>> plain(37), clamped(37);
  for (index_t i = 0; i < svd.size(); ++i) svd.view()[i].s() = random_stretch(random);
  parallel_for(Host{}, svd.size(), ComputeStressDerivative{m, svd.const_view(), plain.view()});
  parallel_for(Host{}, svd.size(), ComputeStressDerivative{m, svd.const_view(), clamped.view(), ClampEigenvalues{}});
  for (index_t i = 0; i < svd.size(); ++i) {
    const Eigen::Vector3d s = svd.view()[i].s();
    const auto d = m.derivative(s), c = ClampEigenvalues{}(d);
    EXPECT_EQ(plain.view()[i].x1111(), d.h11);
    EXPECT_EQ(plain.view()[i].x3223(), (d.d32 - d.s32) / 2);
    EXPECT_EQ(clamped.view()[i].x2211(), c.h21);
    EXPECT_EQ(clamped.view()[i].x2121(), (c.d21 + c.s21) / 2);
  }
}

}  // namespace
}  // namespace physgen::fem
