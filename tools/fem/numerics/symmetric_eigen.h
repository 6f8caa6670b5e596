// Eigenvalues and eigenvectors of symmetric 3x3 matrices by cyclic Jacobi rotations: a fixed number of them without
// branches, so equal, zero and huge eigenvalues are ordinary input, and packs and CUDA threads take the same path.
#pragma once

#include <fem/numerics/scalar.h>

namespace physgen::fem {

template <class S>
struct SymmetricMatrix3 {
  S a11, a21, a31, a22, a32, a33;
};

/// A = sum_k values[k] v_k v_k^T, v_k the columns of `vectors`; in no order.
template <class S>
struct SymmetricEigen {
  Vector3<S> values;
  Matrix3<S> vectors;
};

namespace detail {

/// Cosine, sine and tangent of the angle in [-pi/4, pi/4] that makes a_pq zero.
template <class S>
struct JacobiRotation {
  S c, s, t;

  /// From tan(2 angle) = 2 a_pq / (a_pp - a_qq).
  PHYSGEN_FUNCTION JacobiRotation(const S& app, const S& aqq, const S& apq) {
    using Traits = math::ScalarTraits<S>;
    using Real = RealOf<S>;
    const S half(Real(0.5));
    // Far below the rounding of a matrix of size 1; so the root below is never that of zero.
    const S tiny(sizeof(Real) == 4 ? Real(0x1p-50) : Real(0x1p-400));
    const S d = app - aqq, length = abs(d) + tiny, twice = apq + apq;
    const S inverse = half * Traits::inverse_sqrt(fma(length, length, twice * twice));
    const S cos_square = fma(length, inverse, half);
    const S cos_sin = twice * copysign(inverse, d);
    const S scale = Traits::inverse_sqrt(cos_square);
    c = cos_square * scale;
    s = cos_sin * scale;
    t = s * scale;
  }

  /// (x, y) -> (c x + s y, c y - s x)
  PHYSGEN_FUNCTION void turn(S& x, S& y) const {
    const S kept = x;
    x = fma(c, x, s * y);
    y = fma(c, y, -(s * kept));
  }
};

}  // namespace detail

/// @tparam Rotations 10 in float, 12 in double: measured over 1e5 random matrices of several kinds, one rotation less
/// leaves 170 and 1700 eps |A|, these leave none
/// @param A its largest entry of order 1: beyond 1e15 squares overflow in float, below 1e-10 it would pass for zero
/// @return values to a few eps |A|, vectors orthogonal to a few eps but of length 1 to 9 eps only: divide by v^T v. NaN
/// in A gives NaN in all of it.
template <int Rotations, class S>
PHYSGEN_FUNCTION inline SymmetricEigen<S> symmetric_eigen(SymmetricMatrix3<S> A) {
  using Rotation = detail::JacobiRotation<S>;
  Vector3<S> v1, v2, v3;
  // Zeroes a_pq. Of the other two off-diagonal entries the rotation before zeroed one, into which the `moved` one
  // turns: by sin, with the sign of which of p and q it has as an index.
  const auto zero = [](const Rotation& r, S& app, S& aqq, const S& apq, S& moved, S& vacant, bool moved_has_p) {
    app = fma(r.t, apq, app);
    aqq = fma(-r.t, apq, aqq);
    vacant = (moved_has_p ? -r.s : r.s) * moved;
    moved = r.c * moved;
  };
  const auto zero12 = [&](const Rotation& r) { zero(r, A.a11, A.a22, A.a21, A.a31, A.a32, true); };
  const auto zero13 = [&](const Rotation& r) { zero(r, A.a11, A.a33, A.a31, A.a32, A.a21, false); };
  const auto zero23 = [&](const Rotation& r) { zero(r, A.a22, A.a33, A.a32, A.a21, A.a31, true); };
  const auto turn = [](const Rotation& r, Vector3<S>& vp, Vector3<S>& vq) {
    r.turn(vp[0], vq[0]), r.turn(vp[1], vq[1]), r.turn(vp[2], vq[2]);
  };

  // The first three begin with the identity for V: most products are with 0 or 1. And no entry of A is zero yet.
  {
    const Rotation r12(A.a11, A.a22, A.a21);
    A.a11 = fma(r12.t, A.a21, A.a11);
    A.a22 = fma(-r12.t, A.a21, A.a22);
    r12.turn(A.a31, A.a32);
    const Rotation r13(A.a11, A.a33, A.a31);
    zero13(r13);
    const Rotation r23(A.a22, A.a33, A.a32);
    zero23(r23);
    v1 << r13.c * r12.c, r13.c * r12.s, r13.s;
    v2 << -r12.s, r12.c, r23.s * r13.c;
    v3 << -(r13.s * r12.c), -(r13.s * r12.s), r23.c * r13.c;
    r23.turn(v2[0], v3[0]), r23.turn(v2[1], v3[1]);
  }
  PHYSGEN_UNROLL
  for (int rotation = 3; rotation < Rotations; ++rotation) {
    if (rotation % 3 == 0) {
      const Rotation r(A.a11, A.a22, A.a21);
      zero12(r), turn(r, v1, v2);
    } else if (rotation % 3 == 1) {
      const Rotation r(A.a11, A.a33, A.a31);
      zero13(r), turn(r, v1, v3);
    } else {
      const Rotation r(A.a22, A.a33, A.a32);
      zero23(r), turn(r, v2, v3);
    }
  }
  SymmetricEigen<S> result;
  result.values << A.a11, A.a22, A.a33;
  result.vectors << v1, v2, v3;
  return result;
}

}  // namespace physgen::fem
