// The first Piola-Kirchhoff stress P of each tet, from the SVD of F.
#pragma once

#include <fem/kernels/stress.h>

#include "kernels/svd.h"

namespace physgen::bench {

struct Stress {
  static constexpr const char* name = "stress";
  static constexpr int place = 5;
  static constexpr Domain domain = Domain::tets;
  using Output = elasticity::StressObject;
  using Reads = Operands<Streamed<OutputOf<Svd>>>;
  using Writes = Operands<Streamed<source::Of<Output, domain>>>;
  template <class Real, class... View>
  static auto run(const View&... view) {
    return fem::ComputeStress{material<Real>(), view...};
  }

  template <class T, class Real>
  static elasticity::Stress<T> naive(index_t i, const auto& svds) {
    const auto& svd = svds[i];
    return {formula::stress<T, Real>({svd.U.template cast<T>(), svd.V.template cast<T>(), svd.s.template cast<T>()})};
  }
  template <class T>
  static Matrix3<T> observe(const auto& value) {
    return value.P.template cast<T>();
  }
};

PHYSGEN_BENCH_ROWS(Stress, OnScene);

}  // namespace physgen::bench
