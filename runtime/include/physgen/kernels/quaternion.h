// Rotations as unit quaternions: 4 numbers instead of 9, for storage that counts bytes. Branch-free, for CUDA threads
// and CPU packs.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/kernels/math.h>

#include <Eigen/Core>

namespace physgen {

/// w, x, y, z. Without Eigen's own alignment, which differs with the compiler's -march: the library, built for any
/// processor, and its users share the functions below.
template <class S>
using Quaternion = Eigen::Matrix<S, 4, 1, Eigen::DontAlign>;

/// @param R a rotation, det R = 1
/// @return the unit quaternion of R with w >= 0, to a few eps, half turns included
template <class S>
PHYSGEN_FUNCTION inline Quaternion<S> unit_quaternion(const Eigen::Matrix<S, 3, 3>& R) {
  using math::copysign, math::fma, math::max, math::select;
  using Traits = math::ScalarTraits<S>;
  const S one(typename Traits::Real(1));
  // 4 q q^T stands in sums of entries of R. Its column with the largest diagonal is taken, which is
  // at least 1, so that nothing cancels.
  const S a = R(0, 0) + R(1, 1), b = R(0, 0) - R(1, 1);
  const S ww = (one + R(2, 2)) + a, zz = (one + R(2, 2)) - a, xx = (one - R(2, 2)) + b, yy = (one - R(2, 2)) - b;
  const S wx = R(2, 1) - R(1, 2), wy = R(0, 2) - R(2, 0), wz = R(1, 0) - R(0, 1);
  const S xy = R(1, 0) + R(0, 1), xz = R(0, 2) + R(2, 0), yz = R(2, 1) + R(1, 2);
  const auto w_first = ww > xx;
  const S p0 = select(w_first, ww, wx), p1 = select(w_first, wx, xx), p2 = select(w_first, wy, xy),
          p3 = select(w_first, wz, xz), p_size = max(ww, xx);
  const auto y_first = yy > zz;
  const S r0 = select(y_first, wy, wz), r1 = select(y_first, xy, xz), r2 = select(y_first, yy, yz),
          r3 = select(y_first, yz, zz), r_size = max(yy, zz);
  const auto p_first = p_size > r_size;
  const S q0 = select(p_first, p0, r0), q1 = select(p_first, p1, r1), q2 = select(p_first, p2, r2),
          q3 = select(p_first, p3, r3);
  const S square = fma(q0, q0, fma(q1, q1, fma(q2, q2, q3 * q3)));
  const S scale = copysign(Traits::inverse_sqrt(square), q0);
  return {q0 * scale, q1 * scale, q2 * scale, q3 * scale};
}

/// The rotation matrix of q, with `twice` = 2 / |q|^2.
template <class S>
PHYSGEN_FUNCTION inline Eigen::Matrix<S, 3, 3> rotation_matrix(const Quaternion<S>& q, const S& twice) {
  using math::fma;
  const S one(typename math::ScalarTraits<S>::Real(1));
  const S x2 = q[1] * twice, y2 = q[2] * twice, z2 = q[3] * twice;
  const S wx = q[0] * x2, wy = q[0] * y2, wz = q[0] * z2;
  Eigen::Matrix<S, 3, 3> R;
  R << fma(-q[2], y2, fma(-q[3], z2, one)), fma(q[1], y2, -wz), fma(q[1], z2, wy),  //
      fma(q[1], y2, wz), fma(-q[1], x2, fma(-q[3], z2, one)), fma(q[2], z2, -wx),   //
      fma(q[1], z2, -wy), fma(q[2], z2, wx), fma(-q[1], x2, fma(-q[2], y2, one));
  return R;
}

/// @param q a unit quaternion
template <class S>
PHYSGEN_FUNCTION inline Eigen::Matrix<S, 3, 3> rotation_matrix(const Quaternion<S>& q) {
  return rotation_matrix(q, S(typename math::ScalarTraits<S>::Real(2)));
}

/// @param q a quaternion, not zero, whose length is not 1 because it was rounded coarsely
template <class S>
PHYSGEN_FUNCTION inline Eigen::Matrix<S, 3, 3> rotation_matrix_of_direction(const Quaternion<S>& q) {
  using math::fma;
  using Traits = math::ScalarTraits<S>;
  const S square = fma(q[0], q[0], fma(q[1], q[1], fma(q[2], q[2], q[3] * q[3])));
  // An estimate of 1 / |q|^2 and a step of Newton's: 22 bits and more.
  const S rough = Traits::rough_inverse(square), one(typename Traits::Real(1));
  const S inverse = fma(fma(-square, rough, one), rough, rough);
  return rotation_matrix(q, S(inverse + inverse));
}

}  // namespace physgen

#pragma pop_macro("I")
