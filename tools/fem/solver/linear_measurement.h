// Linear solves by themselves, apart from Newton's method: what is asked of one, and how long its parts took.
#pragma once

#include <fem/solver/settings.h>
#include <physgen/config.h>

#include <algorithm>
#include <vector>

namespace physgen::fem {

/// The norm in which a linear solve is held against its tolerance, relative to that of the right-hand side.
enum class LinearNorm {
  preconditioned,  ///< sqrt(r . z), as Newton's method asks for it: another one for every preconditioner
  euclidean,       ///< |r|: the same for all
};

struct LinearTask {
  double tolerance = 1e-4;
  LinearNorm norm = LinearNorm::preconditioned;
  /// Solves after the first that are timed. The first is not: on CUDA it records the graph that the others run again.
  int repeats = 0;
};

/// A linear solve and its times: medians over the repeats, each taken when the device was done; 0 without repeats.
struct LinearMeasurement {
  LinearResult result;
  double assembly_seconds = 0;        ///< from the tets' tangents to the finest level's stiffness
  double preconditioner_seconds = 0;  ///< all that is made from that stiffness before the first iteration
  double solve_seconds = 0;           ///< from the right-hand side to the step
  double product_seconds = 0;         ///< one product of the finest level's stiffness, of several in a row
  /// Bytes of the arrays that one product, and the kernels of one iteration, read and write; see count_bytes.h.
  index_t product_bytes = 0, iteration_bytes = 0;
};

/// The middle one of some times; 0 of none.
[[nodiscard]] inline double median(std::vector<double> seconds) {
  if (seconds.empty()) return 0;
  const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
  std::ranges::nth_element(seconds, middle);
  return *middle;
}

}  // namespace physgen::fem
