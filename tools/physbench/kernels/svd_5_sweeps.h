// The SVD with 5 sweeps.
#pragma once

#include "kernels/svd.h"

namespace physgen::bench {

struct Svd5Sweeps : SvdOfSweeps<5> {
  static constexpr const char* name = "svd_5_sweeps";
  static constexpr int place = 25;
};

PHYSGEN_BENCH_ROWS(Svd5Sweeps, OnSet);

}  // namespace physgen::bench
