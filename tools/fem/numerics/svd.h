// Rotation-variant singular value decomposition of 3x3 matrices by one-sided Jacobi: branch-free, from one source for
// CUDA threads (registers only) and CPU packs. Working on the columns themselves, not on A^T A, keeps all the digits.
#pragma once

#include <fem/numerics/scalar.h>

namespace physgen::fem {

/// A = U diag(s) V^T with U, V rotations (det +1), s1 >= s2 >= |s3|, and s3 of the sign of det A wherever |s3| is above
/// the rounding of s1.
template <class S>
struct Svd {
  Matrix3<S> U;
  Vector3<S> s;
  Matrix3<S> V;
};

namespace detail {

// A column b of A V and the column v of V that belongs to it, both too long by the same factor: what rotations leave
// out, see orthogonalise().
template <class S>
struct JacobiColumn {
  Vector3<S> b, v;
  S square;  ///< |v|^2, from 1 up
};

// The same at its true length.
template <class S>
struct SvdColumn {
  Vector3<S> b, v;
  S square;  ///< |b|^2
};

/// Makes columns p and q of A V orthogonal by a rotation of at most 45 degrees, without its factor cos: b and v of both
/// grow by 1 / cos, which `square` follows. So a rotation costs one fused multiply-add per number, and an inexact angle
/// costs convergence but no orthogonality: the two coefficients fit each other whatever the angle is.
template <class S>
[[gnu::always_inline]] PHYSGEN_FUNCTION inline void orthogonalise(JacobiColumn<S>& p, JacobiColumn<S>& q) {
  using Traits = math::ScalarTraits<S>;
  using Real = RealOf<S>;
  // Keeps `length` from 0 where both columns are too small to matter.
  const S tiny(std::numeric_limits<Real>::min());
  const S dot = dot3(p.b, q.b);
  const S twice = dot + dot;
  // tan(2 angle) = y / x with x the difference of the columns' squared lengths and y twice their product, both times
  // p.square * q.square: then no division is needed.
  const S x = fma(dot3(p.b, p.b), q.square, -(dot3(q.b, q.b) * p.square));
  const S length_square = fma(x, x, fma(twice * (p.square * q.square), twice, tiny));
  const S length = length_square * Traits::rough_inverse_sqrt(length_square);
  const S coefficient = copysign(Traits::rough_inverse(abs(x) + length), x) * twice;
  const S from_q = coefficient * p.square, from_p = coefficient * q.square;
  const S tan_square = from_q * from_p;
  PHYSGEN_UNROLL
  for (int k = 0; k < 3; ++k) {
    const S b = p.b[k], v = p.v[k];
    p.b[k] = fma(from_q, q.b[k], b);
    p.v[k] = fma(from_q, q.v[k], v);
    q.b[k] = fma(-from_p, b, q.b[k]);
    q.v[k] = fma(-from_p, v, q.v[k]);
  }
  p.square = fma(p.square, tan_square, p.square);
  q.square = fma(q.square, tan_square, q.square);
}

/// Gives a column its true length.
template <class S>
[[gnu::always_inline]] PHYSGEN_FUNCTION inline SvdColumn<S> normalised(const JacobiColumn<S>& column) {
  const S factor = math::ScalarTraits<S>::inverse_sqrt(column.square);
  const Vector3<S> b(column.b[0] * factor, column.b[1] * factor, column.b[2] * factor);
  return {b, {column.v[0] * factor, column.v[1] * factor, column.v[2] * factor}, dot3(b, b)};
}

/// Puts the longer column first; the sign keeps V a rotation.
template <class S>
[[gnu::always_inline]] PHYSGEN_FUNCTION inline void order(SvdColumn<S>& p, SvdColumn<S>& q) {
  const auto wrong = p.square < q.square;
  const auto exchange = [&wrong](S& x, S& y) {
    const S kept = x;
    x = select(wrong, y, x);
    y = select(wrong, -kept, y);
  };
  PHYSGEN_UNROLL
  for (int k = 0; k < 3; ++k) exchange(p.b[k], q.b[k]), exchange(p.v[k], q.v[k]);
  const S kept = p.square;
  p.square = max(p.square, q.square);
  q.square = min(kept, q.square);
}

/// x * factor, at most the largest number; NaN stays.
template <class S>
PHYSGEN_FUNCTION inline S scaled(const S& x, const S& factor) {
  const S largest(std::numeric_limits<RealOf<S>>::max()), product = x * factor;
  return select(abs(product) > largest, copysign(largest, x), product);
}

}  // namespace detail

/// @param A any finite 3x3 matrix: inverted, rank deficient, zero, of any magnitude.
/// @return U and V orthogonal to 32 eps; |U diag(s) V^T - A| <= 24 eps |A| and s to 16 eps s1, each with one smallest
/// subnormal more, except that an s beyond the largest number becomes the largest number. NaN or infinity in gives NaN
/// out, everywhere. s of 2^k A is 2^k s of A, bit for bit, where nothing over- or underflows.
/// @tparam kSweeps trades time for error: 4 converge for every input known to us. 3 leave residuals of some
/// tens of eps in float (`physbench errors` has the figures), and are of no use in double
template <int kSweeps = 4, class S>
PHYSGEN_FUNCTION inline Svd<S> svd(const Matrix3<S>& A) {
  static_assert(kSweeps >= 1, "svd<kSweeps>() needs at least one sweep");
  using Traits = math::ScalarTraits<S>;
  using Real = RealOf<S>;
  const S zero(Real(0)), one(Real(1)), tiny(std::numeric_limits<Real>::min());

  // Entries of [4, 8) at most: fourth powers of columns, grown by up to 2^8, cannot overflow.
  const auto largest = [&A](int j) { return max(abs(A(0, j)), max(abs(A(1, j)), abs(A(2, j)))); };
  const auto scale = Traits::normalising_scale(max(largest(0), max(largest(1), largest(2))));
  const auto column = [&](int j) {
    return detail::JacobiColumn<S>{{A(0, j) * scale.scale, A(1, j) * scale.scale, A(2, j) * scale.scale},
                                   {j == 0 ? one : zero, j == 1 ? one : zero, j == 2 ? one : zero},
                                   one};
  };
  detail::JacobiColumn<S> j1 = column(0), j2 = column(1), j3 = column(2);

  PHYSGEN_UNROLL
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    detail::orthogonalise(j1, j2);
    detail::orthogonalise(j1, j3);
    detail::orthogonalise(j2, j3);
  }
  detail::SvdColumn<S> c1 = detail::normalised(j1), c2 = detail::normalised(j2), c3 = detail::normalised(j3);
  detail::order(c1, c2), detail::order(c1, c3), detail::order(c2, c3);
  const Vector3<S>&b1 = c1.b, &b2 = c2.b, &b3 = c3.b;

  // U from the longest columns down, so that what rank deficiency leaves open is completed by cross products. NaN takes
  // the other branch of each selection, and stays.
  const auto is_zero = c1.square <= tiny;
  const S i1 = Traits::inverse_sqrt(select(is_zero, one, c1.square));
  const Vector3<S> u1(select(is_zero, one, b1[0] * i1), select(is_zero, zero, b1[1] * i1),
                      select(is_zero, zero, b1[2] * i1));
  const S along = dot3(u1, b2);
  const Vector3<S> w(fma(-along, u1[0], b2[0]), fma(-along, u1[1], b2[1]), fma(-along, u1[2], b2[2]));
  // A second column below the rounding of the first has no direction of its own: any one across u1 will do.
  const Real eps = std::numeric_limits<Real>::epsilon();
  const S w_square = dot3(w, w);
  const auto no_direction = w_square <= max(c1.square * S(Real(4) * eps * eps), tiny);
  const auto flat = abs(u1[0]) < S(Real(0.6));  // then u1[1], u1[2] are not both small; else u1[0] is not
  const Vector3<S> across(select(flat, zero, -u1[2]), select(flat, u1[2], zero), select(flat, -u1[1], u1[0]));
  const Vector3<S> t(select(no_direction, across[0], w[0]), select(no_direction, across[1], w[1]),
                     select(no_direction, across[2], w[2]));
  const S i2 = Traits::inverse_sqrt(select(no_direction, dot3(across, across), w_square));
  const Vector3<S> u2(t[0] * i2, t[1] * i2, t[2] * i2);
  const Vector3<S> u3 = cross3<S>(u1, u2);

  // s1 >= s2 >= |s3| by construction: rounding may disagree only where the values agree to a few eps.
  const S s1 = dot3(u1, b1);
  const S along2 = dot3(u2, b2), along3 = dot3(u3, b3);
  const S positive = select(along2 < zero, zero, along2);
  const S s2 = select(positive > s1, s1, positive);
  const S s3 = select(abs(along3) > s2, copysign(s2, along3), along3);
  Svd<S> result;
  result.U << u1, u2, u3;
  result.s << detail::scaled(s1, scale.inverse), detail::scaled(s2, scale.inverse), detail::scaled(s3, scale.inverse);
  result.V << c1.v, c2.v, c3.v;
  return result;
}

/// The rotation next to A: the polar factor R = U V^T, det R = +1 for inverted A, too.
template <class S>
PHYSGEN_FUNCTION inline Matrix3<S> polar_rotation(const Matrix3<S>& A) {
  const Svd<S> parts = svd(A);
  return multiply_transpose<S>(parts.U, parts.V);
}

}  // namespace physgen::fem
