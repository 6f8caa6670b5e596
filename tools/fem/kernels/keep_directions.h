// Kernel: keeps the principal directions of a decomposition that is a local of a fused kernel, for the force
// differentials of later steps.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/numerics/scalar.h>
#include <physgen/kernels/pack.h>

namespace physgen::fem {

template <class SvdView, class DirectionView>
struct KeepDirections {
  using Scalar = typename DirectionView::Precision;
  SvdView decomposition;     ///< elasticity::DeformationSvd, of which U and V are read
  DirectionView directions;  ///< elasticity::PrincipalDirections, written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const Matrix3<S> U = decomposition[i].U(), V = decomposition[i].V();
    const auto out = directions[i];
    out.U() = U;
    out.V() = V;
  }
};

}  // namespace physgen::fem

#pragma pop_macro("I")
