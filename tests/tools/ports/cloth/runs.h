// The two programs.
#pragma once

#include <setting.h>

#include <vector>

namespace sheet {

struct Result {
  std::vector<Point> positions;
  int iterations = 0;
  double spring_seconds = 0, search_seconds = 0;  ///< of forces and derivatives, and of conjugate gradients
};

/// Plain loops over structs.
Result run_plain(const Setting& setting, int steps);

/// The same by kernels. @param one_lane whether one object at a time, else as the library chooses
Result run_kernels(const Setting& setting, int steps, bool one_lane);

}  // namespace sheet
