// The kernels whose error is measured beside their speed: what each reads and writes, how to make it from views, and
// what its output says about the problem it solves (problem.h).
#pragma once

#include <fem/compute_svd.h>
#include <fem/definiteness.h>
#include <fem/dp_from_df.h>
#include <fem/stress_derivative.h>
#include <fem/svd_arrays.h>

#include "../kernels.h"
#include "variant_list.h"

namespace physgen::bench {

/// Types of the objects of a kernel's arrays, in the order in which it takes them.
template <class... Object>
struct Objects {};

// Problems. They are host code; this file is for CUDA translation units, too.
template <class Real>
struct SvdProblem;
template <class T>
struct SvdParts;
template <class Real, class Filter>
struct StressDerivativeProblem;
template <class Real>
struct DpFromDfProblem;

// A kernel is of this form:
//
//   struct SvdVariant {
//     static constexpr const char* name;
//     static constexpr int numbers;                             read and written per object
//     template <class Real> using Problem;
//     using Reads, Writes = Objects<...>;
//     template <class Real, class... View> static auto make(const View&... view);   over inputs, then outputs
//     template <class Real> static auto load(const Problem<Real>::Input&);          values of the inputs, as a tuple
//     template <class T> static Problem<Real>::Result result(const Value&... output);
//     using Naive;                                              of naive.h: the comparison `eigen`; void for none
//   };

/// What kernels that solve SvdProblem share.
template <class Output>
struct OfSvd {
  template <class Real>
  using Problem = SvdProblem<Real>;
  using Reads = Objects<elasticity::DeformationGradientObject>;
  using Writes = Objects<Output>;
  using Naive = void;
  template <class Real>
  static auto load(const auto& input) {
    return std::make_tuple(elasticity::DeformationGradient<Real>{input.F});
  }
};

/// The SVD with a number of sweeps; 4 is the usual one.
template <int kSweeps>
struct SvdVariant : OfSvd<elasticity::DeformationSvdObject> {
  static constexpr const char* name = kSweeps == 3 ? "svd_3_sweeps" : kSweeps == 5 ? "svd_5_sweeps" : "svd";
  static constexpr int numbers = 30;
  using Naive = std::conditional_t<kSweeps == 4, Svd, void>;
  template <class Real, class... View>
  static auto make(const View&... view) {
    return fem::ComputeSvd{view..., fem::Sweeps<kSweeps>{}};
  }
  template <class T>
  static auto result(const auto& svd) {
    return SvdParts<T>{svd.U.template cast<T>(), svd.s.template cast<T>(), svd.V.template cast<T>(), {}};
  }
};

/// Rotations as unit quaternions; their matrices are formed in the wider type.
struct SvdQuaternions : OfSvd<elasticity::QuaternionSvdObject> {
  static constexpr const char* name = "svd_quaternions";
  static constexpr int numbers = 20;
  template <class Real, class... View>
  static auto make(const View&... view) {
    return fem::ComputeQuaternionSvd{view...};
  }
  template <class T>
  static auto result(const auto& svd) {
    const auto matrix = [](const auto& q) -> Eigen::Matrix<T, 3, 3> {
      const T w = T(q[0]), x = T(q[1]), y = T(q[2]), z = T(q[3]);
      Eigen::Matrix<T, 3, 3> R;
      R << 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),  //
          2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),   //
          2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y);
      return R;
    };
    return SvdParts<T>{matrix(svd.u), svd.s.template cast<T>(), matrix(svd.v), {}};
  }
};

struct SingularValues : OfSvd<elasticity::PrincipalStretchesObject> {
  static constexpr const char* name = "singular_values";
  static constexpr int numbers = 12;
  template <class Real, class F, class S>
  static auto make(const F& gradients, const S& stretches) {
    return fem::ComputeSvdParts{gradients, fem::skip, stretches, fem::skip};
  }
  template <class T>
  static auto result(const auto& stretches) {
    return SvdParts<T>{{}, stretches.s.template cast<T>(), {}, {}};
  }
};

struct PolarRotation : OfSvd<elasticity::ElementRotationObject> {
  static constexpr const char* name = "polar_rotation";
  static constexpr int numbers = 18;
  template <class Real, class... View>
  static auto make(const View&... view) {
    return fem::ComputePolarRotation{view...};
  }
  template <class T>
  static auto result(const auto& rotation) {
    return SvdParts<T>{{}, {}, {}, rotation.R.template cast<T>()};
  }
};

/// s and V.
struct SvdWithoutU : OfSvd<void> {
  static constexpr const char* name = "svd_without_u";
  static constexpr int numbers = 21;
  using Writes = Objects<elasticity::PrincipalStretchesObject, elasticity::ElementRotationObject>;
  template <class Real, class F, class S, class V>
  static auto make(const F& gradients, const S& stretches, const V& rotations) {
    return fem::ComputeSvdParts{gradients, fem::skip, stretches, rotations};
  }
  template <class T>
  static auto result(const auto& stretches, const auto& rotation) {
    return SvdParts<T>{{}, stretches.s.template cast<T>(), rotation.R.template cast<T>(), {}};
  }
};

/// U and s.
struct SvdWithoutV : OfSvd<void> {
  static constexpr const char* name = "svd_without_v";
  static constexpr int numbers = 21;
  using Writes = Objects<elasticity::ElementRotationObject, elasticity::PrincipalStretchesObject>;
  template <class Real, class F, class U, class S>
  static auto make(const F& gradients, const U& rotations, const S& stretches) {
    return fem::ComputeSvdParts{gradients, rotations, stretches, fem::skip};
  }
  template <class T>
  static auto result(const auto& rotation, const auto& stretches) {
    return SvdParts<T>{rotation.R.template cast<T>(), stretches.s.template cast<T>(), {}, {}};
  }
};

/// @tparam Filter of derivative_problems.h, KernelFilter the same of definiteness.h
template <class Filter, class KernelFilter>
struct StressDerivativeVariant {
  static constexpr bool filters = !std::is_same_v<KernelFilter, fem::Unfiltered>;
  static constexpr const char* name = !filters ? "stress_derivative"
                                      : std::is_same_v<KernelFilter, fem::ClampEigenvalues>
                                          ? "stress_derivative_clamped"
                                          : "stress_derivative_absolute";
  static constexpr int numbers = 15;
  template <class Real>
  using Problem = StressDerivativeProblem<Real, Filter>;
  using Reads = Objects<elasticity::DeformationSvdObject>;
  using Writes = Objects<elasticity::StressDerivativeObject>;
  using Naive = std::conditional_t<filters, void, StressDerivative>;
  template <class Real, class... View>
  static auto make(const View&... view) {
    return fem::ComputeStressDerivative{material<Real>(), view..., KernelFilter{}};
  }
  template <class Real>
  static auto load(const auto& input) {
    elasticity::DeformationSvd<Real> svd;
    svd.U.setIdentity(), svd.V.setIdentity();
    svd.s = input.s;
    return std::make_tuple(svd);
  }
  template <class T>
  static auto result(const auto& x) {
    Eigen::Matrix<T, 12, 1> all;
    all << T(x.x1111), T(x.x2211), T(x.x3311), T(x.x2222), T(x.x3322), T(x.x3333), T(x.x2121), T(x.x2112), T(x.x3131),
        T(x.x3113), T(x.x3232), T(x.x3223);
    return all;
  }
};

struct DpFromDfVariant {
  static constexpr const char* name = "dp_from_df";
  static constexpr int numbers = 48;
  template <class Real>
  using Problem = DpFromDfProblem<Real>;
  using Reads = Objects<elasticity::DeformationSvdObject, elasticity::StressDerivativeObject,
                        elasticity::DeformationGradientDifferentialObject>;
  using Writes = Objects<elasticity::StressDifferentialObject>;
  using Naive = DpFromDf;
  template <class Real, class... View>
  static auto make(const View&... view) {
    return fem::DpFromDf{view...};
  }
  template <class Real>
  static auto load(const auto& input) {
    return std::make_tuple(input.svd, input.x, elasticity::DeformationGradientDifferential<Real>{input.dF});
  }
  template <class T>
  static auto result(const auto& stress) {
    return Eigen::Matrix<T, 3, 3>(stress.dP.template cast<T>());
  }
};

}  // namespace physgen::bench
