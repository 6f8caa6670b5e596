// The stress derivative with the absolute values of its eigenvalues.
#pragma once

#include "kernels/stress_derivative.h"

namespace physgen::bench {

struct Absolute {
  static constexpr const char* name = "absolute stress derivative";
  template <class T>
  static T value(T eigenvalue) {
    return std::abs(eigenvalue);
  }
};

struct StressDerivativeAbsolute : FilteredStressDerivative<Absolute, fem::AbsoluteEigenvalues> {
  static constexpr const char* name = "stress_derivative_absolute";
  static constexpr int place = 36;
};

PHYSGEN_BENCH_ROWS(StressDerivativeAbsolute, OnSet);

}  // namespace physgen::bench
