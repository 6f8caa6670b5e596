// Kernel: isotropic stress derivative in principal axes, 3 stretches in, 12 scalars out (60 bytes per element in
// float), made positive semidefinite if wanted.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/materials/definiteness.h>
#include <physgen/kernels/pack.h>

namespace physgen::fem {

template <class Model, class SvdView, class DerivativeView, class Filter = Unfiltered>
struct ComputeStressDerivative {
  using Scalar = typename DerivativeView::Precision;
  Model material;             ///< such as NeoHookean<Scalar>
  SvdView decomposition;      ///< elasticity::DeformationSvd, of which s alone is read
  DerivativeView derivative;  ///< elasticity::StressDerivative, written
  Filter filter = {};         ///< Unfiltered, ClampEigenvalues or AbsoluteEigenvalues

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const S half(Scalar(0.5));
    const Vector3<S> s = decomposition[i].s();
    const PrincipalDerivative<S> d = filter(material.derivative(s));
    const auto out = derivative[i];
    out.x1111() = d.h11;
    out.x2211() = d.h21;
    out.x3311() = d.h31;
    out.x2222() = d.h22;
    out.x3322() = d.h32;
    out.x3333() = d.h33;
    out.x2121() = half * (d.d21 + d.s21);
    out.x2112() = half * (d.d21 - d.s21);
    out.x3131() = half * (d.d31 + d.s31);
    out.x3113() = half * (d.d31 - d.s31);
    out.x3232() = half * (d.d32 + d.s32);
    out.x3223() = half * (d.d32 - d.s32);
  }
};

}  // namespace physgen::fem

#pragma pop_macro("I")
