// The polar rotation R = U V^T alone.
#pragma once

#include "kernels/svd.h"

namespace physgen::bench {

struct PolarRotation : OfSvd {
  static constexpr const char* name = "polar_rotation";
  static constexpr int place = 34;
  using Writes = Operands<Streamed<source::Of<elasticity::ElementRotationObject, Domain::tets>>>;
  template <class Real, class... View>
  static auto run(const View&... view) {
    return fem::ComputePolarRotation{view...};
  }
  template <class T>
  static auto result(const auto& rotation) {
    return SvdParts<T>{{}, {}, {}, rotation.R.template cast<T>()};
  }
};

PHYSGEN_BENCH_ROWS(PolarRotation, OnSet);

}  // namespace physgen::bench
