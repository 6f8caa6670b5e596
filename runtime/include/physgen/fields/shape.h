// The structures a field can have: how many elements are stored, in which order, and the Eigen value they make up.
// Each gives: count, Value<S>, value<S>(elements) that reads elements[k], and store<S>(value, elements) that assigns
// them.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/config.h>

#include <Eigen/Core>

namespace physgen::shape {

/// One element.
struct Scalar {
  static constexpr bool is_scalar = true;
  static constexpr int count = 1;
  template <class S>
  using Value = S;
};

/// R x C matrix, column by column. Vector<N> is N x 1.
template <int R, int C>
struct Matrix {
  static constexpr bool is_scalar = false;
  static constexpr bool is_skew = false;
  static constexpr int count = R * C;
  template <class S>
  using Value = Eigen::Matrix<S, R, C>;

  /// Number of the element at row r, column c.
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr int index(int r, int c) { return c * R + r; }

  template <class S, class Elements>
  [[nodiscard]] PHYSGEN_FUNCTION static Value<S> value(const Elements& elements) {
    Value<S> m;
    PHYSGEN_UNROLL
    for (int k = 0; k < count; ++k) m(k % R, k / R) = elements[k];
    return m;
  }
  template <class S, class Elements>
  PHYSGEN_FUNCTION static void store(const Value<S>& m, const Elements& elements) {
    PHYSGEN_UNROLL
    for (int k = 0; k < count; ++k) elements[k] = m(k % R, k / R);
  }
};

template <int N>
using Vector = Matrix<N, 1>;

/// Rotation stored as its 3x3 matrix. @pre the matrix is orthogonal with determinant +1; not checked
struct Rotation : Matrix<3, 3> {};

/// N x N matrix of which a triangle is stored, column by column: without its diagonal where the matrix is skew. The
/// value is the full matrix; storing a value takes that triangle.
template <int N, bool kSkew>
struct Triangle {
  static constexpr bool is_scalar = false;
  static constexpr bool is_skew = kSkew;
  static constexpr int first_row = kSkew ? 1 : 0;  ///< of column 0
  static constexpr int count = N * (N + 1 - 2 * first_row) / 2;
  template <class S>
  using Value = Eigen::Matrix<S, N, N>;

  /// @pre r > c where the matrix is skew
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr int index(int r, int c) {
    if (!kSkew && r < c) return index(c, r);
    return c * (N - first_row) - c * (c - 1) / 2 + (r - c - first_row);
  }

  template <class S, class Elements>
  [[nodiscard]] PHYSGEN_FUNCTION static Value<S> value(const Elements& elements) {
    Value<S> m;
    PHYSGEN_UNROLL
    for (int c = 0; c < N; ++c) {
      if constexpr (kSkew) m(c, c) = S(0);
      PHYSGEN_UNROLL
      for (int r = c + first_row; r < N; ++r) {
        m(r, c) = elements[index(r, c)];
        if constexpr (kSkew) {
          m(c, r) = -m(r, c);
        } else {
          m(c, r) = m(r, c);
        }
      }
    }
    return m;
  }
  template <class S, class Elements>
  PHYSGEN_FUNCTION static void store(const Value<S>& m, const Elements& elements) {
    PHYSGEN_UNROLL
    for (int c = 0; c < N; ++c) {
      PHYSGEN_UNROLL
      for (int r = c + first_row; r < N; ++r) elements[index(r, c)] = m(r, c);
    }
  }
};

/// Symmetric N x N matrix: xx yx zx yy zy zz.
template <int N>
struct Symmetric : Triangle<N, false> {};

/// Skew-symmetric N x N matrix: yx zx zy.
template <int N>
struct Skew : Triangle<N, true> {};

/// Diagonal N x N matrix: its N diagonal entries. The value is the vector of them; value.asDiagonal() is the matrix.
template <int N>
struct Diagonal : Matrix<N, 1> {};

}  // namespace physgen::shape

#pragma pop_macro("I")
