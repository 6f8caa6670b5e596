// Prescribed components taken out of vectors and blocks.
#pragma once

#include <fem/numerics/scalar.h>

namespace physgen::fem {

namespace detail {

/// A vector, or a pack of them, with 0 in prescribed components.
template <class S, class Constraint>
PHYSGEN_FUNCTION inline Vector3<S> free_part(const Vector3<S>& v, const Constraint& constraint) {
  const same_lanes_t<S, std::int32_t> fixed = constraint.fixed();
  const S zero(RealOf<S>(0));
  return {select((fixed & 1) == 0, v[0], zero), select((fixed & 2) == 0, v[1], zero),
          select((fixed & 4) == 0, v[2], zero)};
}

/// A block with 0 in the rows and columns of prescribed components.
template <class Scalar>
PHYSGEN_FUNCTION inline Matrix3<Scalar> free_block(const Matrix3<Scalar>& block, int fixed_rows, int fixed_columns) {
  Matrix3<Scalar> result;
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) {
      const bool fixed = (fixed_rows >> r & 1) != 0 || (fixed_columns >> c & 1) != 0;
      result(r, c) = fixed ? Scalar(0) : block(r, c);
    }
  }
  return result;
}

}  // namespace detail

}  // namespace physgen::fem
