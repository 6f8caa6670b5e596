// Kernel: first Piola-Kirchhoff stress of an isotropic material, P = U diag(g(s)) V^T.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/materials/material.h>
#include <physgen/kernels/pack.h>

namespace physgen::fem {

template <class Model, class SvdView, class StressView>
struct ComputeStress {
  using Scalar = typename StressView::Precision;
  Model material;         ///< such as NeoHookean<Scalar>
  SvdView decomposition;  ///< elasticity::DeformationSvd
  StressView stress;      ///< elasticity::Stress, written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const auto in = decomposition[i];
    const Matrix3<S> U = in.U(), V = in.V();
    const Vector3<S> s = in.s(), g = material.stress(s);
    Matrix3<S> scaled;
    scaled.col(0) = U.col(0) * g[0];
    scaled.col(1) = U.col(1) * g[1];
    scaled.col(2) = U.col(2) * g[2];
    stress[i].P() = multiply_transpose<S>(scaled, V);
  }
};

}  // namespace physgen::fem

#pragma pop_macro("I")
