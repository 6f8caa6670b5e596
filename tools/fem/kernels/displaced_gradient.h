// Kernel: the deformation gradient from displacements, F = 1 + Ds(u) Dm^-1. Near rest F - 1 keeps its digits in float,
// which positions in float would lose.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/kernels/tet.h>

namespace physgen::fem {

template <class TetView, class DisplacementView, class RestView, class GradientView>
struct ComputeDisplacedGradient {
  using Scalar = typename GradientView::Precision;
  TetView tets;                    ///< elasticity::Tet
  DisplacementView displacements;  ///< elasticity::NodeDisplacement, from rest
  RestView rest;                   ///< elasticity::RestShape
  GradientView gradient;           ///< elasticity::DeformationGradient, written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const Matrix3<S> ds =
        detail::edge_matrix<Scalar>(tets, i, [this](auto node) { return displacements[node].dx().get(); });
    const Matrix3<S> dm_inverse = rest[i].dm_inverse();
    Matrix3<S> F = multiply<S>(ds, dm_inverse);
    for (int k = 0; k < 3; ++k) F(k, k) += S(Scalar(1));
    gradient[i].F() = F;
  }
};

}  // namespace physgen::fem

#pragma pop_macro("I")
