// The SVD into arrays of structs of its three parts, beside the one record of all that svd/aos writes.
#pragma once

#include "kernels/svd.h"

namespace physgen::bench {

struct SvdArrays : OfSvd {
  static constexpr const char* name = "svd";
  static constexpr int place = 4;
  static constexpr const char* only_aos = "aos_three_arrays";  ///< its one layout is so called
  using Writes = Operands<Streamed<source::Of<elasticity::ElementRotationObject, Domain::tets>>,
                          Streamed<source::Of<elasticity::PrincipalStretchesObject, Domain::tets>>,
                          Streamed<source::Of<elasticity::ElementRotationObject, Domain::tets>>>;
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

PHYSGEN_BENCH_ROWS(SvdArrays, OnScene);

}  // namespace physgen::bench
