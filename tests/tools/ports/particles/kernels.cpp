// The program as a user of the library writes it.
#include "../report.h"
#include "particles.h"
#include "runs.h"

namespace fluid {

Result run_kernels(int side, int steps) {
  const int count = side * side * side;
  Water water;
  water.box = box_of(side);
  Fluid dam{ParticleArray<float>(count), water};
  for (int i = 0; i < count; ++i) dam.particles[i].x() = Eigen::Vector3f(position_of(i, side).data());
  Result result;
  for (int step = 0; step < steps; ++step) {
    result.row_seconds += ports::seconds_of([&] { dam.find_neighbours(step % steps_between_orders == 0); });
    result.kernel_seconds += ports::seconds_of([&] { dam.move(); });
  }
  result.neighbours = static_cast<std::size_t>(dam.neighbours.entries().size());
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3f x = dam.particles[i].x();
    result.positions.push_back({x[0], x[1], x[2]});
  }
  return result;
}

}  // namespace fluid
