// The SVD with its rotations as unit quaternions; their matrices are formed in the wider type.
#pragma once

#include "kernels/svd.h"

namespace physgen::bench {

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

PHYSGEN_BENCH_ROWS(SvdQuaternions, OnSet);

}  // namespace physgen::bench
