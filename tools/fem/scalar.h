// The small vocabulary every kernel of tools/fem is written in: fixed-size matrices over a scalar S (float, double or a
// SIMD pack) and the scalar functions, named so that unqualified calls work for all of them.
#pragma once

#include <physgen/math.h>

#include <Eigen/Core>

namespace physgen::fem {

using math::abs;
using math::copysign;
using math::fma;
using math::log;
using math::log1p;
using math::max;
using math::min;
using math::select;
using math::sqrt;

template <class S>
using Vector3 = Eigen::Matrix<S, 3, 1>;
template <class S>
using Matrix3 = Eigen::Matrix<S, 3, 3>;

/// The type of one number of S: float or double.
template <class S>
using RealOf = typename math::ScalarTraits<S>::Real;

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
