// The program as a user of the library writes it: the example cloth, with times.
#include <cloth.h>

#include "../report.h"
#include "runs.h"

namespace sheet {

namespace {

template <int kLanes>
Result run(const Setting& setting, int steps) {
  Sheet sheet(setting);
  Result result;
  for (int step = 0; step < steps; ++step) {
    result.spring_seconds += ports::seconds_of([&] { sheet.compute_springs<kLanes>(); });
    result.search_seconds += ports::seconds_of([&] { result.iterations += sheet.solve_and_move<kLanes>(); });
  }
  for (index_t i = 0; i < sheet.nodes.size(); ++i) {
    const Eigen::Vector3d x = sheet.nodes[i].x();
    result.positions.push_back({x[0], x[1], x[2]});
  }
  return result;
}

}  // namespace

Result run_kernels(const Setting& setting, int steps, bool one_lane) {
  return one_lane ? run<1>(setting, steps) : run<0>(setting, steps);
}

}  // namespace sheet
