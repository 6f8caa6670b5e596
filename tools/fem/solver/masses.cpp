#include <fem/mesh/geometry.h>
#include <fem/solver/masses.h>
#include <physgen/error.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace physgen::fem {

std::vector<double> lumped_masses(const TetMesh& mesh, std::span<const Point> rest, double density) {
  std::vector<double> masses(static_cast<std::size_t>(mesh.nodes), 0.0);
  for (const auto& tet : mesh.tets) {
    const double quarter = density * six_volumes(tet, rest) / 24;
    for (const Index node : tet) masses[static_cast<std::size_t>(node)] += quarter;
  }
  return masses;
}

double stable_time_step(const TetMesh& mesh, std::span<const Point> rest, const LameParameters& lame, double density) {
  const double modulus = lame.lambda + 2 * lame.mu;
  if (!(modulus > 0) || !(density > 0) || !std::isfinite(modulus / density)) {
    throw Error("the stable time step follows from the speed of waves: lambda + 2 mu = " + std::to_string(modulus) +
                " Pa and a density of " + std::to_string(density) + " kg/m^3 must be positive numbers");
  }
  double largest = 0;  // sum of 1/h^2
  for (const auto& tet : mesh.tets) {
    const double volume = six_volumes(tet, rest);
    const auto corner = [&](std::size_t c) { return rest[static_cast<std::size_t>(tet[c])]; };
    double sum = 0;
    for (std::size_t c = 0; c < 4; ++c) {  // 1/h = area of the opposite face over three volumes
      const Point first = corner((c + 1) % 4);
      const Point normal = cross(difference(corner((c + 2) % 4), first), difference(corner((c + 3) % 4), first));
      sum += dot(normal, normal) / (volume * volume);
    }
    largest = std::max(largest, sum);
  }
  return 1 / std::sqrt(largest * modulus / density);
}

}  // namespace physgen::fem
