// The sheet of the plain program as it begins, and the constants of the method; those of the example stand in cloth.h.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace sheet {

using Point = std::array<double, 3>;

struct Link {
  std::array<std::int32_t, 2> ends;
  double length, stiffness;
};

/// A level square sheet of 1 m and 0.3 kg that hangs at two corners: springs to the next nodes along rows and columns,
/// across, and to the next but one.
struct Setting {
  std::vector<Point> positions;
  std::vector<double> masses, free;
  std::vector<Link> springs;
  std::vector<std::int32_t> first;    ///< of each node's springs, and the number of all
  std::vector<std::int32_t> touches;  ///< springs
  double step = 0.002;                ///< of time [s]
  double gravity = -9.81, tolerance = 1e-10;
  int most_iterations = 100;
};

/// @param side nodes along each side
Setting make_setting(int side);

}  // namespace sheet
