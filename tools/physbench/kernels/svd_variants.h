// The SVD in other forms: with other numbers of sweeps, into arrays of its parts, some of its parts alone, and with its
// rotations as quaternions.
#pragma once

#include "kernels/svd.h"

namespace physgen::bench {

struct Svd3Sweeps : SvdOfSweeps<3> {
  static constexpr const char* name = "svd_3_sweeps";
  static constexpr int place = 23;
};

struct Svd5Sweeps : SvdOfSweeps<5> {
  static constexpr const char* name = "svd_5_sweeps";
  static constexpr int place = 25;
};

using StoredRotations = Streamed<source::Of<elasticity::ElementRotationObject, Domain::tets>>;
using StoredStretches = Streamed<source::Of<elasticity::PrincipalStretchesObject, Domain::tets>>;

/// Arrays of structs, beside the one record of all that svd/aos writes.
struct SvdArrays : OfSvd {
  static constexpr const char* name = "svd";
  static constexpr int place = 4;
  static constexpr const char* only_aos = "aos_three_arrays";  ///< its one layout is so called
  using Writes = Operands<StoredRotations, StoredStretches, StoredRotations>;
  template <class Real, class... View>
  static auto run(const View&... view) {
    return fem::ComputeSvdParts{view...};
  }

  template <class T, class Real>
  static auto naive(index_t i, const auto& gradients) {
    return Svd::naive<T, Real>(i, gradients);
  }
  template <class T>
  static auto observe(const auto& svd) {
    return Svd::observe<T>(svd);
  }
  template <class T>
  static auto observe(const auto& U, const auto& s, const auto& V) {
    return Svd::observe<T>(
        elasticity::DeformationSvd<T>{U.R.template cast<T>(), V.R.template cast<T>(), s.s.template cast<T>()});
  }
};

/// s and V.
struct SvdWithoutU : OfSvd {
  static constexpr const char* name = "svd_without_u";
  static constexpr int place = 31;
  using Writes = Operands<StoredStretches, StoredRotations>;
  template <class Real>
  static auto run(const auto& gradients, const auto& stretches, const auto& rotations) {
    return fem::ComputeSvdParts{gradients, fem::skip, stretches, rotations};
  }
  template <class T>
  static auto result(const auto& stretches, const auto& rotation) {
    return SvdParts<T>{{}, stretches.s.template cast<T>(), rotation.R.template cast<T>(), {}};
  }
};

/// U and s.
struct SvdWithoutV : OfSvd {
  static constexpr const char* name = "svd_without_v";
  static constexpr int place = 32;
  using Writes = Operands<StoredRotations, StoredStretches>;
  template <class Real>
  static auto run(const auto& gradients, const auto& rotations, const auto& stretches) {
    return fem::ComputeSvdParts{gradients, rotations, stretches, fem::skip};
  }
  template <class T>
  static auto result(const auto& rotation, const auto& stretches) {
    return SvdParts<T>{rotation.R.template cast<T>(), stretches.s.template cast<T>(), {}, {}};
  }
};

/// s alone.
struct SingularValues : OfSvd {
  static constexpr const char* name = "singular_values";
  static constexpr int place = 33;
  using Writes = Operands<StoredStretches>;
  template <class Real>
  static auto run(const auto& gradients, const auto& stretches) {
    return fem::ComputeSvdParts{gradients, fem::skip, stretches, fem::skip};
  }
  template <class T>
  static auto result(const auto& stretches) {
    return SvdParts<T>{{}, stretches.s.template cast<T>(), {}, {}};
  }
};

/// R = U V^T alone.
struct PolarRotation : OfSvd {
  static constexpr const char* name = "polar_rotation";
  static constexpr int place = 34;
  using Writes = Operands<StoredRotations>;
  template <class Real>
  static auto run(const auto& gradients, const auto& rotations) {
    return fem::ComputePolarRotation{gradients, rotations};
  }
  template <class T>
  static auto result(const auto& rotation) {
    return SvdParts<T>{{}, {}, {}, rotation.R.template cast<T>()};
  }
};

/// Rotations as unit quaternions; their matrices are formed in the wider type.
struct SvdQuaternions : OfSvd {
  static constexpr const char* name = "svd_quaternions";
  static constexpr int place = 30;
  using Writes = Operands<Streamed<source::Of<elasticity::QuaternionSvdObject, Domain::tets>>>;
  template <class Real, class... View>
  static auto run(const View&... view) {
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

PHYSGEN_BENCH_ROWS(Svd3Sweeps, OnSet);
PHYSGEN_BENCH_ROWS(Svd5Sweeps, OnSet);
PHYSGEN_BENCH_ROWS(SvdArrays, OnScene);
PHYSGEN_BENCH_ROWS(SvdWithoutU, OnSet);
PHYSGEN_BENCH_ROWS(SvdWithoutV, OnSet);
PHYSGEN_BENCH_ROWS(SingularValues, OnSet);
PHYSGEN_BENCH_ROWS(PolarRotation, OnSet);
PHYSGEN_BENCH_ROWS(SvdQuaternions, OnSet);

}  // namespace physgen::bench
