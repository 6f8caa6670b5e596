// Kernels: block Jacobi on one level, in scaled unknowns. K is df/dx, negative semidefinite: -D K has positive
// eigenvalues.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/numerics/scalar.h>
#include <physgen/kernel.h>

namespace physgen::fem {

namespace detail {

/// D r of node(s) i.
template <class S, class InverseView, class ResidualView, class I>
PHYSGEN_FUNCTION inline Vector3<S> block_jacobi(const InverseView& inverse, const ResidualView& residual, I i) {
  const Matrix3<S> D = inverse[i].D();
  const Vector3<S> r = residual[i].df(), zero = Vector3<S>::Constant(S(RealOf<S>(0)));
  return multiply_add<S>(D, r, zero);
}

}  // namespace detail

/// z = D r.
template <class InverseView, class ResidualView, class CorrectionView>
struct ApplyBlockJacobi {
  using Scalar = typename CorrectionView::Precision;
  InverseView inverse;         ///< quasistatic::NodeInverse
  ResidualView residual;       ///< elasticity::NodeForceDifferential
  CorrectionView corrections;  ///< elasticity::NodeDisplacement, written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    corrections[i].dx() = detail::block_jacobi<S>(inverse, residual, i);
  }
};

}  // namespace physgen::fem

#pragma pop_macro("I")
