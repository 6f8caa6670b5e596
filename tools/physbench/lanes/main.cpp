// Measures the kernels from which the rule of detail/chosen_lanes.h comes: physbench_lanes [PART OF A NAME [SECONDS]].
// Each takes so many seconds; a line of JSON for each is printed. Times are of one thread: OMP_NUM_THREADS=1.
#include <cstdlib>

#include "grid_rows.h"
#include "particle_rows.h"
#include "tet_rows.h"

namespace physgen::lane_kernels {
namespace {

template <class Real>
void measure(const Bench& bench) {
  measure_particles<Real>(bench);
  measure_cloth<Real>(bench);
  measure_hexahedra<Real>(bench);
  measure_cells<Real>(bench);
  measure_tets<Real>(bench);
}

}  // namespace
}  // namespace physgen::lane_kernels

int main(int argc, char** argv) {
  const physgen::lane_kernels::Bench bench(argc > 1 ? argv[1] : "", argc > 2 ? std::atof(argv[2]) : 0.5);
  physgen::lane_kernels::measure<float>(bench);
  physgen::lane_kernels::measure<double>(bench);
}
