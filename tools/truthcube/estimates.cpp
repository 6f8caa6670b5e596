#include "estimates.h"

#include <algorithm>
#include <cmath>

namespace physgen::truthcube {

using fem::Point;

double plate_reaction(std::span<const fem::Index> upper, std::span<const Point> forces,
                      std::span<const fem::PlaneContact> planes) {
  double reaction = 0;
  for (const fem::Index n : upper) reaction -= forces[static_cast<std::size_t>(n)][2];
  if (!planes.empty()) reaction -= planes.back().force;
  return reaction;
}

Estimates make_estimates(std::span<const fem::MeshLevel> levels, std::span<const fem::Index> coarse_upper,
                         double reaction, std::span<const Point> positions, const fem::NodeState& coarser,
                         double order) {
  const fem::MeshLevel &finest = levels[0], &coarse = levels[1];
  Estimates estimates;
  const double factor = std::exp2(order), left = 1 / (factor - 1);
  estimates.reaction = left * (factor * reaction - plate_reaction(coarse_upper, coarser.forces, coarser.planes));
  double sum = 0, most = 0;
  std::size_t common = 0;
  for (std::size_t n = 0; n < finest.parents.size(); ++n) {
    const auto [first, second] = finest.parents[n];
    if (first != second) continue;  // no node of the coarser mesh
    const auto parent = static_cast<std::size_t>(first);
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double difference =
          (positions[n][k] - finest.rest[n][k]) - (coarser.positions[parent][k] - coarse.rest[parent][k]);
      square += difference * difference;
    }
    sum += square;
    most = std::max(most, square);
    ++common;
  }
  estimates.error_rms = left * std::sqrt(sum / static_cast<double>(common));
  estimates.error_max = left * std::sqrt(most);
  return estimates;
}

}  // namespace physgen::truthcube
