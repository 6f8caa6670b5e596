// The two programs.
#pragma once

#include <vector>

#include "setting.h"

namespace sheet {

struct Result {
  std::vector<Point> positions;
  int iterations = 0;
  double spring_seconds = 0, search_seconds = 0;  ///< of forces and derivatives, and of conjugate gradients
};

/// Plain loops over structs.
Result run_plain(const Setting& setting, int steps);

/// The example. @param side nodes along each side of its sheet, which is that of make_setting(side)
Result run_kernels(int side, int steps);

}  // namespace sheet
