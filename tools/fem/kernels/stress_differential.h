// Kernel: stress differential dP from deformation gradient differential dF through the principal frame, 192 bytes per
// element in float. The most frequent product of an implicit solver.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/numerics/scalar.h>
#include <physgen/kernels/pack.h>

namespace physgen::fem {

namespace detail {

/// dP^ of dF^ in the principal frame. @param x an accessor or value of elasticity::StressDerivative
template <class S, class Derivative>
[[gnu::always_inline]] PHYSGEN_FUNCTION inline Matrix3<S> principal_differential(const Derivative& x,
                                                                                 const Matrix3<S>& dF) {
  const S x2211 = x.x2211(), x3311 = x.x3311(), x3322 = x.x3322();
  const S x2121 = x.x2121(), x2112 = x.x2112();
  const S x3131 = x.x3131(), x3113 = x.x3113();
  const S x3232 = x.x3232(), x3223 = x.x3223();
  Matrix3<S> dP;
  dP(0, 0) = fma(S(x.x1111()), dF(0, 0), fma(x2211, dF(1, 1), x3311 * dF(2, 2)));
  dP(1, 1) = fma(x2211, dF(0, 0), fma(S(x.x2222()), dF(1, 1), x3322 * dF(2, 2)));
  dP(2, 2) = fma(x3311, dF(0, 0), fma(x3322, dF(1, 1), S(x.x3333()) * dF(2, 2)));
  dP(1, 0) = fma(x2121, dF(1, 0), x2112 * dF(0, 1));
  dP(0, 1) = fma(x2112, dF(1, 0), x2121 * dF(0, 1));
  dP(2, 0) = fma(x3131, dF(2, 0), x3113 * dF(0, 2));
  dP(0, 2) = fma(x3113, dF(2, 0), x3131 * dF(0, 2));
  dP(2, 1) = fma(x3232, dF(2, 1), x3223 * dF(1, 2));
  dP(1, 2) = fma(x3223, dF(2, 1), x3232 * dF(1, 2));
  return dP;
}

/// dP = U dP^(U^T dF V) V^T
template <class S, class Derivative>
[[gnu::always_inline]] PHYSGEN_FUNCTION inline Matrix3<S> stress_differential(const Matrix3<S>& U, const Matrix3<S>& V,
                                                                              const Derivative& x,
                                                                              const Matrix3<S>& dF) {
  const Matrix3<S> principal = principal_differential<S>(x, multiply<S>(transpose_multiply<S>(U, dF), V));
  return multiply_transpose<S>(multiply<S>(U, principal), V);
}

}  // namespace detail

/// dP = dP/dF : dF [Pa].
template <class SvdView, class DerivativeView, class DifferentialView, class StressDifferentialView>
struct ComputeStressDifferential {
  using Scalar = typename StressDifferentialView::Precision;
  SvdView decomposition;          ///< elasticity::DeformationSvd, of which U and V are read
  DerivativeView derivative;      ///< elasticity::StressDerivative
  DifferentialView differential;  ///< elasticity::DeformationGradientDifferential
  StressDifferentialView stress;  ///< elasticity::StressDifferential, written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const auto rotations = decomposition[i];
    const Matrix3<S> U = rotations.U(), V = rotations.V(), dF = differential[i].dF();
    stress[i].dP() = detail::stress_differential<S>(U, V, derivative[i], dF);
  }
};

}  // namespace physgen::fem

#pragma pop_macro("I")
