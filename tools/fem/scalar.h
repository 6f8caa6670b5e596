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

}  // namespace physgen::fem
