// The stress derivative with its negative eigenvalues clamped to 0.
#pragma once

#include "kernels/stress_derivative.h"

namespace physgen::bench {

struct Clamp {
  static constexpr const char* name = "clamped stress derivative";
  template <class T>
  static T value(T eigenvalue) {
    return eigenvalue < 0 ? T(0) : eigenvalue;
  }
};

struct StressDerivativeClamped : FilteredStressDerivative<Clamp, fem::ClampEigenvalues> {
  static constexpr const char* name = "stress_derivative_clamped";
  static constexpr int place = 35;
};

PHYSGEN_BENCH_ROWS(StressDerivativeClamped, OnSet);

}  // namespace physgen::bench
