// The program as a user of the library writes it: the example cloth, with times.
#include <cloth.h>

#include "../report.h"
#include "runs.h"

namespace sheet {

Result run_kernels(int side, int steps) {
  Cloth cloth(side);
  Result result;
  for (int step = 0; step < steps; ++step) {
    result.spring_seconds += ports::seconds_of([&] { cloth.compute_springs(); });
    result.search_seconds += ports::seconds_of([&] { result.iterations += cloth.solve_and_move(); });
  }
  for (const auto node : cloth.nodes) result.positions.push_back({node.x()[0], node.x()[1], node.x()[2]});
  return result;
}

}  // namespace sheet
