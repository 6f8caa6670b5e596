// s and V of the SVD.
#pragma once

#include "kernels/svd.h"

namespace physgen::bench {

struct SvdWithoutU : OfSvd {
  static constexpr const char* name = "svd_without_u";
  static constexpr int place = 31;
  using Writes = Operands<Streamed<source::Of<elasticity::PrincipalStretchesObject, Domain::tets>>,
                          Streamed<source::Of<elasticity::ElementRotationObject, Domain::tets>>>;
  template <class Real, class F, class S, class V>
  static auto run(const F& gradients, const S& stretches, const V& rotations) {
    return fem::ComputeSvdParts{gradients, fem::skip, stretches, rotations};
  }
  template <class T>
  static auto result(const auto& stretches, const auto& rotation) {
    return SvdParts<T>{{}, stretches.s.template cast<T>(), rotation.R.template cast<T>(), {}};
  }
};

PHYSGEN_BENCH_ROWS(SvdWithoutU, OnSet);

}  // namespace physgen::bench
