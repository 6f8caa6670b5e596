// The two programs.
#pragma once

#include <cstdint>
#include <vector>

#include "setting.h"

namespace fluid {

struct Result {
  std::vector<Point> positions;
  std::size_t neighbours = 0;                  ///< of the last step
  double row_seconds = 0, kernel_seconds = 0;  ///< of building lists, and of all that is computed over them
};

constexpr int steps_between_orders = 10;  // after which particles are ordered by cell

/// Plain loops over structs.
Result run_plain(const Setting& setting, int steps);

/// The same by kernels. @param one_lane whether one object at a time, else as the library chooses
Result run_kernels(const Setting& setting, int steps, bool one_lane);

}  // namespace fluid
