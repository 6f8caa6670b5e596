// The deformed Truth Cube as a closed formula plus noise.
#include <fem/mesh/truth_cube.h>

#include <cmath>
#include <random>

namespace physgen::fem {

TruthCube make_truth_cube(Index cells, std::uint64_t seed) {
  TruthCube cube;
  cube.mesh = make_box_mesh(cells, cells, cells);
  cube.rest.reserve(static_cast<std::size_t>(cube.mesh.nodes));
  cube.deformed.reserve(static_cast<std::size_t>(cube.mesh.nodes));
  const double cell = TruthCube::side / cells;
  // Lateral stretch 1 + widening, widening = bulge 4 h (1 - h) at height h: 4 h (1 - h) averages to 2/3, and a volume
  // kept on average needs a mean lateral stretch of 1/sqrt(1 - compression).
  const double bulge = 1.5 * (1 / std::sqrt(1 - TruthCube::compression) - 1);

  std::mt19937_64 random(seed);
  // The generator's top 53 bits, because the standard distributions differ between libraries.
  const auto noise = [&random, cell] { return 0.02 * cell * (static_cast<double>(random() >> 11) * 0x1p-52 - 1); };
  for (Index z = 0; z <= cells; ++z) {
    for (Index y = 0; y <= cells; ++y) {
      for (Index x = 0; x <= cells; ++x) {
        const Point p{x * cell, y * cell, z * cell};
        const double h = static_cast<double>(z) / cells;
        const double widening = bulge * 4 * h * (1 - h);
        const double centre = TruthCube::side / 2;
        Point q{p[0] + (p[0] - centre) * widening, p[1] + (p[1] - centre) * widening,
                p[2] * (1 - TruthCube::compression)};
        if (z != 0 && z != cells) {
          for (double& coordinate : q) coordinate += noise();
        }
        cube.rest.push_back(p);
        cube.deformed.push_back(q);
      }
    }
  }
  return cube;
}

}  // namespace physgen::fem
