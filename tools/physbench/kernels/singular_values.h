// The singular values alone.
#pragma once

#include "kernels/svd.h"

namespace physgen::bench {

struct SingularValues : OfSvd {
  static constexpr const char* name = "singular_values";
  static constexpr int place = 33;
  using Writes = Operands<Streamed<source::Of<elasticity::PrincipalStretchesObject, Domain::tets>>>;
  template <class Real, class F, class S>
  static auto run(const F& gradients, const S& stretches) {
    return fem::ComputeSvdParts{gradients, fem::skip, stretches, fem::skip};
  }
  template <class T>
  static auto result(const auto& stretches) {
    return SvdParts<T>{{}, stretches.s.template cast<T>(), {}, {}};
  }
};

PHYSGEN_BENCH_ROWS(SingularValues, OnSet);

}  // namespace physgen::bench
