// Makes a stress derivative positive semidefinite, as Newton's method with conjugate gradients needs it: function
// objects that a kernel is given. The eigenvalues are those of the 3x3 block H and, of the pairs (a, b), D and S.
#pragma once

#include <fem/materials/material.h>
#include <fem/numerics/symmetric_eigen.h>

namespace physgen::fem {

namespace detail {

/// f(H) of the 3x3 block, H = sum lambda v v^T -> sum f(lambda) v v^T, and f(D), f(S).
/// @return as d [Pa]; error of H <= 8 eps |H| (measured 4.1), D and S exact; NaN or infinity in H gives NaN in H
template <class S, class Function>
PHYSGEN_FUNCTION inline PrincipalDerivative<S> map_eigenvalues(const PrincipalDerivative<S>& d, const Function& f) {
  using Real = RealOf<S>;
  constexpr int rotations = sizeof(Real) == 4 ? 10 : 12;
  const S largest = max(max(max(abs(d.h11), abs(d.h21)), max(abs(d.h31), abs(d.h22))), max(abs(d.h32), abs(d.h33)));
  const auto scale = math::ScalarTraits<S>::normalising_scale(largest);
  const S& k = scale.scale;
  const SymmetricEigen<S> e =
      symmetric_eigen<rotations>(SymmetricMatrix3<S>{k * d.h11, k * d.h21, k * d.h31, k * d.h22, k * d.h32, k * d.h33});
  Matrix3<S> scaled;  // v_k f(lambda_k)
  PHYSGEN_UNROLL
  for (int c = 0; c < 3; ++c) {
    // Over |v|^2, which many rotations have left a few eps from 1.
    const Vector3<S> v = e.vectors.col(c);
    const S value = f(e.values[c]) * scale.inverse * (S(Real(2)) - dot3(v, v));
    PHYSGEN_UNROLL
    for (int r = 0; r < 3; ++r) scaled(r, c) = e.vectors(r, c) * value;
  }
  const auto entry = [&e, &scaled](int r, int c) {
    return fma(scaled(r, 0), e.vectors(c, 0), fma(scaled(r, 1), e.vectors(c, 1), scaled(r, 2) * e.vectors(c, 2)));
  };
  return {entry(0, 0), entry(1, 0), entry(2, 0), entry(1, 1), entry(2, 1), entry(2, 2),
          f(d.d21),    f(d.d31),    f(d.d32),    f(d.s21),    f(d.s31),    f(d.s32)};
}

}  // namespace detail

/// The derivative as it is.
struct Unfiltered {
  template <class S>
  PHYSGEN_FUNCTION PrincipalDerivative<S> operator()(const PrincipalDerivative<S>& d) const {
    return d;
  }
};

/// Negative eigenvalues become 0: the nearest positive semidefinite operator. Source: Teran et al. 2005.
struct ClampEigenvalues {
  template <class S>
  PHYSGEN_FUNCTION PrincipalDerivative<S> operator()(const PrincipalDerivative<S>& d) const {
    const auto clamp = [](const S& x) {
      const S zero(RealOf<S>(0));
      return select(x < zero, zero, x);  // not max, which may lose a NaN
    };
    return detail::map_eigenvalues(d, clamp);
  }
};

/// Eigenvalues become their absolute values. Source: Chen et al. 2024, "Stabler Neo-Hookean simulation: absolute
/// eigenvalue filtering for projected Newton".
struct AbsoluteEigenvalues {
  template <class S>
  PHYSGEN_FUNCTION PrincipalDerivative<S> operator()(const PrincipalDerivative<S>& d) const {
    return detail::map_eigenvalues(d, [](const S& x) { return abs(x); });
  }
};

}  // namespace physgen::fem
