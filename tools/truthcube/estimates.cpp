#include "estimates.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "state_windows.h"

namespace physgen::truthcube {

using fem::Point;

double plate_reaction(std::span<const Point> on_upper, std::span<const fem::PlaneContact> planes) {
  double reaction = 0;
  for (const Point& force : on_upper) reaction -= force[2];
  if (!planes.empty()) reaction -= planes.back().force;
  return reaction;
}

Estimates make_estimates(std::span<const fem::MeshLevel> levels, std::span<const fem::Index> coarse_upper,
                         double reaction, BodyState& state, double order, std::size_t window) {
  const fem::MeshLevel &finest = levels[0], &coarse = levels[1];
  const double factor = std::exp2(order), left = 1 / (factor - 1);
  const auto contacts = state.coarser_contacts().value();
  const double coarse_reaction = plate_reaction(state.forces(1, coarse_upper), contacts);
  double sum = 0, most = 0;
  std::size_t common = 0;
  each_window(0, finest.parents.size(), WindowSizes(window).nodes(), [&](std::span<const fem::Index> numbers) {
    std::vector<fem::Index> nodes, parents;  // that are nodes of both meshes
    for (const fem::Index n : numbers) {
      const auto [first, second] = finest.parents[static_cast<std::size_t>(n)];
      if (first != second) continue;
      nodes.push_back(n);
      parents.push_back(first);
    }
    const std::vector<Point> fine = state.positions(0, nodes), of_parents = state.positions(1, parents);
    for (std::size_t i = 0; i < fine.size(); ++i) {
      const Point &at_rest = finest.rest[static_cast<std::size_t>(nodes[i])],
                  &parent_at_rest = coarse.rest[static_cast<std::size_t>(parents[i])];
      double square = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double difference = (fine[i][k] - at_rest[k]) - (of_parents[i][k] - parent_at_rest[k]);
        square += difference * difference;
      }
      sum += square;
      most = std::max(most, square);
      ++common;
    }
  });
  if (!state.is_here()) return {};
  return {left * (factor * reaction - coarse_reaction), left * std::sqrt(sum / static_cast<double>(common)),
          left * std::sqrt(most)};
}

}  // namespace physgen::truthcube
