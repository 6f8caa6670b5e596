#include <fem/mesh/graded_cube.h>

#include <algorithm>
#include <cmath>

namespace physgen::fem {

std::vector<double> graded_positions(Index cells, double side, double grading) {
  std::vector<double> positions(static_cast<std::size_t>(cells) + 1);
  for (std::size_t k = 0; 2 * k < positions.size(); ++k) {
    positions[k] = side / 2 * std::pow(2 * (static_cast<double>(k) / cells), grading);
    positions[positions.size() - 1 - k] = side - positions[k];
  }
  return positions;
}

double graded_flatness(Index cells, double grading) {
  const std::vector<double> at = graded_positions(cells, 1, grading);
  double narrowest = 1, widest = 0;
  for (std::size_t k = 1; k < at.size(); ++k) {
    narrowest = std::min(narrowest, at[k] - at[k - 1]);
    widest = std::max(widest, at[k] - at[k - 1]);
  }
  return widest / narrowest;
}

void grade_cube(std::span<Point> rest, Index cells, double side, double grading) {
  if (grading == 1) return;
  const std::vector<double> at = graded_positions(cells, side, grading);
  const std::size_t n = at.size();
  for (std::size_t node = 0; node < rest.size(); ++node) {
    rest[node] = {at[node % n], at[node / n % n], at[node / n / n]};
  }
}

}  // namespace physgen::fem
