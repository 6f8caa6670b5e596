// Kernel: singular value decomposition of deformation gradients, F = U diag(s) V^T.
#pragma once

#include <fem/svd.h>
#include <physgen/pack.h>

namespace physgen::fem {

/// See svd() for what is guaranteed.
template <class GradientView, class SvdView>
struct ComputeSvd {
  using Scalar = typename SvdView::Precision;
  GradientView gradient;  ///< elasticity::DeformationGradient
  SvdView decomposition;  ///< elasticity::DeformationSvd, written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const Matrix3<S> F = gradient[i].F();
    const Svd<S> result = svd(F);
    const auto out = decomposition[i];
    out.U() = result.U;
    out.V() = result.V;
    out.s() = result.s;
  }
};
template <class... Views>
ComputeSvd(Views...) -> ComputeSvd<Views...>;

}  // namespace physgen::fem
