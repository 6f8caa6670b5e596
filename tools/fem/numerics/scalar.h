// The small vocabulary every kernel of tools/fem is written in: fixed-size matrices over a scalar S (float, double or a
// SIMD pack) and the scalar functions, named so that unqualified calls work for all of them.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/kernels/math.h>

#include <Eigen/Core>

namespace physgen::fem {

using math::abs;
using math::copysign;
using math::fma;
using math::max;
using math::min;
using math::select;

template <class S>
using Vector3 = Eigen::Matrix<S, 3, 1>;
template <class S>
using Matrix3 = Eigen::Matrix<S, 3, 3>;

/// The type of one number of S: float or double.
template <class S>
using RealOf = typename math::ScalarTraits<S>::Real;

// Products of vectors, each a chain of fused multiply-adds. (Eigen's own leave the fusion to the compiler, and that is
// off: see CMakeLists.txt.)
template <class S>
PHYSGEN_FUNCTION inline S dot3(const Vector3<S>& a, const Vector3<S>& b) {
  return fma(a[0], b[0], fma(a[1], b[1], a[2] * b[2]));
}
template <class S>
PHYSGEN_FUNCTION inline Vector3<S> cross3(const Vector3<S>& a, const Vector3<S>& b) {
  return {fma(a[1], b[2], -(a[2] * b[1])), fma(a[2], b[0], -(a[0] * b[2])), fma(a[0], b[1], -(a[1] * b[0]))};
}

// Always inline, as products of matrices below: which functions GCC puts elsewhere depends on what else a file
// compiles, and a program has one of several files' versions of a kernel.
/// A x + b
template <class S>
[[gnu::always_inline]] PHYSGEN_FUNCTION inline Vector3<S> multiply_add(const Matrix3<S>& A, const Vector3<S>& x,
                                                                       const Vector3<S>& b) {
  Vector3<S> result;
  PHYSGEN_UNROLL
  for (int r = 0; r < 3; ++r) result[r] = fma(A(r, 0), x[0], fma(A(r, 1), x[1], fma(A(r, 2), x[2], b[r])));
  return result;
}
/// A^T x + b
template <class S>
[[gnu::always_inline]] PHYSGEN_FUNCTION inline Vector3<S> transpose_multiply_add(const Matrix3<S>& A,
                                                                                 const Vector3<S>& x,
                                                                                 const Vector3<S>& b) {
  Vector3<S> result;
  PHYSGEN_UNROLL
  for (int c = 0; c < 3; ++c) result[c] = fma(A(0, c), x[0], fma(A(1, c), x[1], fma(A(2, c), x[2], b[c])));
  return result;
}

// Products of 3x3 matrices, always inline: GCC puts Eigen's own for packs into functions of their own, and operands
// that pass through memory cost more than the arithmetic. Each entry is a chain of three fused multiply-adds.
namespace detail {

template <class S, class Left, class Right>
[[gnu::always_inline]] PHYSGEN_FUNCTION inline Matrix3<S> product(const Left& left, const Right& right) {
  Matrix3<S> result;
  PHYSGEN_UNROLL
  for (int c = 0; c < 3; ++c) {
    PHYSGEN_UNROLL
    for (int r = 0; r < 3; ++r) {
      result(r, c) = fma(left(r, 0), right(0, c), fma(left(r, 1), right(1, c), left(r, 2) * right(2, c)));
    }
  }
  return result;
}

}  // namespace detail

/// A B
template <class S>
[[gnu::always_inline]] PHYSGEN_FUNCTION inline Matrix3<S> multiply(const Matrix3<S>& A, const Matrix3<S>& B) {
  return detail::product<S>(A, B);
}
/// A^T B
template <class S>
[[gnu::always_inline]] PHYSGEN_FUNCTION inline Matrix3<S> transpose_multiply(const Matrix3<S>& A, const Matrix3<S>& B) {
  const auto a = [&A](int r, int c) -> const S& { return A(c, r); };
  return detail::product<S>(a, B);
}
/// A B^T
template <class S>
[[gnu::always_inline]] PHYSGEN_FUNCTION inline Matrix3<S> multiply_transpose(const Matrix3<S>& A, const Matrix3<S>& B) {
  const auto b = [&B](int r, int c) -> const S& { return B(c, r); };
  return detail::product<S>(A, b);
}

}  // namespace physgen::fem

#pragma pop_macro("I")
