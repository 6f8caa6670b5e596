// The two programs: a dam that breaks.
#pragma once

#include <array>
#include <vector>

namespace fluid {

using Point = std::array<float, 3>;

struct Result {
  std::vector<Point> positions;
  std::size_t neighbours = 0;                  ///< of the last step
  double row_seconds = 0, kernel_seconds = 0;  ///< of building lists, and of all that is computed over them
};

/// `side` particles along each edge of the water.
inline Point position_of(int i, int side) {
  const auto at = [](int k) { return static_cast<float>(k) * 0.02F + 0.01F; };
  return {at(i % side), at(i / side % side), at(i / side / side)};
}
inline std::array<float, 3> box_of(int side) {
  const float edge = static_cast<float>(side) * 0.02F;
  return {2 * edge, edge, 2 * edge};
}

constexpr int steps_between_orders = 10;  // after which particles are ordered by cell

/// Plain loops over structs.
Result run_plain(int side, int steps);

/// The example.
Result run_kernels(int side, int steps);

}  // namespace fluid
