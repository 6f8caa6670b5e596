// Computes what a step of Newton's method needs of positions by one kernel, newton_update_separate by five. Corner
// forces, U, V and the derivative are kept.
#pragma once

#include <fem/kernels/groups.h>

#include "kernels/newton_update_separate.h"

namespace physgen::bench {

struct NewtonUpdateFused : NewtonUpdateSeparate {
  static constexpr const char* name = "newton_update_fused";
  static constexpr int place = 16;
  using Writes =
      Operands<Streamed<source::Of<elasticity::PrincipalDirectionsObject, domain>>,
               Streamed<source::Of<Derivative::Output, domain>>, Streamed<source::Of<ElasticForce::Output, domain>>>;
  template <class Real>
  static auto run(const auto& tets, const auto& positions, const auto& rest, const auto& directions,
                  const auto& derivatives, const auto& corners) {
    return fem::fuse_newton_update(material<Real>(), tets, positions, rest, directions, derivatives, corners);
  }

  template <class T>
  static auto observe(const NewtonOfTet<T>& tet) {
    return tet.observed();
  }
  template <class T>
  static auto observe(const auto& directions, const auto& derivative, const auto& corners) {
    return kept<T>(directions, derivative, corners);
  }
};

PHYSGEN_BENCH_ROWS(NewtonUpdateFused, OnScene);

}  // namespace physgen::bench
