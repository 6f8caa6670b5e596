// The program as a user of the library writes it.
#include "kernels.h"

#include <physgen/parallel_for.h>
#include <physgen/topology.h>

#include "../report.h"
#include "runs.h"

namespace fluid {

namespace {

std::vector<Point> positions_of(const ParticleArray<float>& particles) {
  std::vector<Point> positions;
  positions.reserve(static_cast<std::size_t>(particles.size()));
  for (index_t i = 0; i < particles.size(); ++i) {
    const auto x = particles.const_view()[i].x();
    positions.push_back({x[0], x[1], x[2]});
  }
  return positions;
}

/// The lists as arrays.
struct Lists {
  RangeArray<float> ranges;
  NeighbourArray<float> entries;

  void fill(const NeighbourLists& lists) {
    const auto rows = static_cast<index_t>(lists.first.size()) - 1, count = static_cast<index_t>(lists.entries.size());
    if (ranges.size() != rows) ranges = RangeArray<float>(rows);
    if (entries.size() < count) entries = NeighbourArray<float>(count + count / 4);
    for (index_t i = 0; i < rows; ++i) {
      ranges.view()[i].begin() = lists.first[static_cast<std::size_t>(i)];
      ranges.view()[i].end() = lists.first[static_cast<std::size_t>(i) + 1];
    }
    for (index_t e = 0; e < count; ++e) entries.view()[e].j() = lists.entries[static_cast<std::size_t>(e)];
  }
};

template <int kLanes>
Result run(const Setting& setting, int steps) {
  const Water& water = setting.water;
  const auto n = static_cast<index_t>(setting.positions.size());
  ParticleArray<float> particles(n);
  for (index_t i = 0; i < n; ++i) {
    for (int k = 0; k < 3; ++k) {
      particles.view()[i].x()[k] = setting.positions[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
    }
  }
  Result result;
  Lists lists;
  for (int step = 0; step < steps; ++step) {
    result.row_seconds += ports::seconds_of([&] {
      if (step % steps_between_orders == 0) {
        ArraySet(particles).permute(order_by_cell(positions_of(particles), water.reach));
      }
      const NeighbourLists found = find_neighbours(positions_of(particles), water.reach);
      lists.fill(found);
      result.neighbours = found.entries.size();
    });
    result.kernel_seconds += ports::seconds_of([&] {
      const auto all = particles.view();
      const Rows rows(lists.ranges.const_view(), lists.entries.const_view(), n);
      parallel_for(Host{}, n, lanes<kLanes>(ComputeDensity{rows, all, water}));
      parallel_for(Host{}, n, lanes<kLanes>(ComputeForces{rows, all, water}));
      parallel_for(Host{}, n, lanes<kLanes>(Move{all, water}));
    });
  }
  result.positions = positions_of(particles);
  return result;
}

}  // namespace

Result run_kernels(const Setting& setting, int steps, bool one_lane) {
  return one_lane ? run<1>(setting, steps) : run<0>(setting, steps);
}

}  // namespace fluid
