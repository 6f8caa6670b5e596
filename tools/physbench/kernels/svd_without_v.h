// U and s of the SVD.
#pragma once

#include "kernels/svd.h"

namespace physgen::bench {

struct SvdWithoutV : OfSvd {
  static constexpr const char* name = "svd_without_v";
  static constexpr int place = 32;
  using Writes = Operands<Streamed<source::Of<elasticity::ElementRotationObject, Domain::tets>>,
                          Streamed<source::Of<elasticity::PrincipalStretchesObject, Domain::tets>>>;
  template <class Real, class F, class U, class S>
  static auto run(const F& gradients, const U& rotations, const S& stretches) {
    return fem::ComputeSvdParts{gradients, rotations, stretches, fem::skip};
  }
  template <class T>
  static auto result(const auto& rotation, const auto& stretches) {
    return SvdParts<T>{rotation.R.template cast<T>(), stretches.s.template cast<T>(), {}, {}};
  }
};

PHYSGEN_BENCH_ROWS(SvdWithoutV, OnSet);

}  // namespace physgen::bench
