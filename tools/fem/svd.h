// Rotation-variant singular value decomposition of 3x3 matrices by one-sided Jacobi: branch-free, from one source for
// CUDA threads (registers only) and CPU packs. Working on the columns themselves, not on A^T A, keeps all the digits.
#pragma once

#include <fem/scalar.h>

namespace physgen::fem {

/// A = U diag(s) V^T with U, V rotations (det +1) and s1 >= s2 >= |s3|; s3 < 0 exactly when det A < 0.
template <class S>
struct Svd {
  Matrix3<S> U;
  Vector3<S> s;
  Matrix3<S> V;
};

namespace detail {

/// Rotates columns p, q of A (and those of V with them) by the angle in [-pi/4, pi/4] that makes them orthogonal.
template <class S>
PHYSGEN_FUNCTION inline void orthogonalise(Vector3<S>& ap, Vector3<S>& aq, Vector3<S>& vp, Vector3<S>& vq) {
  using Traits = math::ScalarTraits<S>;
  using Real = RealOf<S>;
  const S zero(Real(0)), one(Real(1)), half(Real(0.5)), tiny(std::numeric_limits<Real>::min());
  const S sum = fma(ap[0] + aq[0], ap[0] - aq[0], fma(ap[1] + aq[1], ap[1] - aq[1], (ap[2] + aq[2]) * (ap[2] - aq[2])));
  const S dot = fma(ap[0], aq[0], fma(ap[1], aq[1], ap[2] * aq[2]));
  const S twice = dot + dot;
  // tan(2 angle) = twice / sum; both below the root of the smallest number: columns too small to matter, left alone.
  const S square = fma(sum, sum, twice * twice);
  const auto matters = square > tiny;
  const S inverse = Traits::inverse_sqrt(max(square, tiny));
  const S cos2 = select(matters, abs(sum) * inverse, one);
  const S sin2 = select(matters, copysign(one, sum) * twice * inverse, zero);
  const S cos_square = fma(half, cos2, half);
  const S inverse_cos = Traits::inverse_sqrt(cos_square);
  const S c = cos_square * inverse_cos;
  const S d = half * sin2 * inverse_cos;
  const auto rotate = [&c, &d](S& x, S& y) {
    const S kept = x;
    x = fma(c, x, d * y);
    y = fma(c, y, -(d * kept));
  };
  rotate(ap[0], aq[0]), rotate(ap[1], aq[1]), rotate(ap[2], aq[2]);
  rotate(vp[0], vq[0]), rotate(vp[1], vq[1]), rotate(vp[2], vq[2]);
}

/// Puts the longer column first; the sign keeps V a rotation.
template <class S>
PHYSGEN_FUNCTION inline void order(S& np, S& nq, Vector3<S>& ap, Vector3<S>& aq, Vector3<S>& vp, Vector3<S>& vq) {
  const auto wrong = np < nq;
  const auto exchange = [&wrong](S& x, S& y) {
    const S kept = x;
    x = select(wrong, y, x);
    y = select(wrong, -kept, y);
  };
  exchange(ap[0], aq[0]), exchange(ap[1], aq[1]), exchange(ap[2], aq[2]);
  exchange(vp[0], vq[0]), exchange(vp[1], vq[1]), exchange(vp[2], vq[2]);
  const S kept = np;
  np = max(np, nq);
  nq = min(kept, nq);
}

template <class S>
PHYSGEN_FUNCTION inline S dot3(const Vector3<S>& a, const Vector3<S>& b) {
  return fma(a[0], b[0], fma(a[1], b[1], a[2] * b[2]));
}

}  // namespace detail

/// @param A any finite 3x3 matrix: inverted, rank deficient, zero, of any magnitude.
/// @return |U diag(s) V^T - A| <= 24 eps |A|, U and V orthogonal to 32 eps, always; NaN or infinity in gives NaN out.
/// s of 2^k A is 2^k s of A, bit for bit. `Sweeps` trades time for error: 4 converge for every input known to us.
template <int Sweeps = 4, class S>
PHYSGEN_FUNCTION inline Svd<S> svd(const Matrix3<S>& A) {
  using Traits = math::ScalarTraits<S>;
  using Real = RealOf<S>;
  using detail::dot3;
  const S zero(Real(0)), one(Real(1)), tiny(std::numeric_limits<Real>::min());

  const auto largest = [&A](int j) { return max(abs(A(0, j)), max(abs(A(1, j)), abs(A(2, j)))); };
  const auto scale = Traits::normalising_scale(max(largest(0), max(largest(1), largest(2))));
  Vector3<S> b1(A(0, 0) * scale.scale, A(1, 0) * scale.scale, A(2, 0) * scale.scale);
  Vector3<S> b2(A(0, 1) * scale.scale, A(1, 1) * scale.scale, A(2, 1) * scale.scale);
  Vector3<S> b3(A(0, 2) * scale.scale, A(1, 2) * scale.scale, A(2, 2) * scale.scale);
  Vector3<S> v1(one, zero, zero), v2(zero, one, zero), v3(zero, zero, one);

  PHYSGEN_UNROLL
  for (int sweep = 0; sweep < Sweeps; ++sweep) {
    detail::orthogonalise(b1, b2, v1, v2);
    detail::orthogonalise(b1, b3, v1, v3);
    detail::orthogonalise(b2, b3, v2, v3);
  }
  S n1 = dot3(b1, b1), n2 = dot3(b2, b2), n3 = dot3(b3, b3);
  detail::order(n1, n2, b1, b2, v1, v2);
  detail::order(n1, n3, b1, b3, v1, v3);
  detail::order(n2, n3, b2, b3, v2, v3);

  // U from the longest columns down, so that what rank deficiency leaves open is completed by cross products.
  const auto nonzero = n1 > tiny;
  const S i1 = Traits::inverse_sqrt(max(n1, tiny));
  const Vector3<S> u1(select(nonzero, b1[0] * i1, one), select(nonzero, b1[1] * i1, zero),
                      select(nonzero, b1[2] * i1, zero));
  const S along = dot3(u1, b2);
  const Vector3<S> w(fma(-along, u1[0], b2[0]), fma(-along, u1[1], b2[1]), fma(-along, u1[2], b2[2]));
  // A second column below the rounding of the first has no direction of its own: any one across u1 will do.
  const Real eps = std::numeric_limits<Real>::epsilon();
  const S nw = dot3(w, w);
  const auto has_direction = nw > max(n1 * S(Real(4) * eps * eps), tiny);
  const auto flat = abs(u1[0]) < S(Real(0.6));
  const Vector3<S> across(select(flat, zero, -u1[2]), select(flat, u1[2], zero), select(flat, -u1[1], u1[0]));
  const Vector3<S> t(select(has_direction, w[0], across[0]), select(has_direction, w[1], across[1]),
                     select(has_direction, w[2], across[2]));
  const S i2 = Traits::inverse_sqrt(select(has_direction, nw, dot3(across, across)));
  const Vector3<S> u2(t[0] * i2, t[1] * i2, t[2] * i2);
  const Vector3<S> u3(fma(u1[1], u2[2], -(u1[2] * u2[1])), fma(u1[2], u2[0], -(u1[0] * u2[2])),
                      fma(u1[0], u2[1], -(u1[1] * u2[0])));

  // s1 >= s2 >= |s3| by construction: rounding may disagree only where the values agree to a few eps.
  const S s1 = dot3(u1, b1);
  const S s2 = min(max(dot3(u2, b2), zero), s1);
  const S along3 = dot3(u3, b3);
  const S s3 = copysign(min(abs(along3), s2), along3);
  Svd<S> result;
  result.U << u1, u2, u3;
  result.s << s1 * scale.inverse, s2 * scale.inverse, s3 * scale.inverse;
  result.V << v1, v2, v3;
  return result;
}

}  // namespace physgen::fem
