// The SVD with 3 sweeps.
#pragma once

#include "kernels/svd.h"

namespace physgen::bench {

struct Svd3Sweeps : SvdOfSweeps<3> {
  static constexpr const char* name = "svd_3_sweeps";
  static constexpr int place = 23;
};

PHYSGEN_BENCH_ROWS(Svd3Sweeps, OnSet);

}  // namespace physgen::bench
