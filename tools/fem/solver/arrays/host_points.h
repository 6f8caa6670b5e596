// Arrays of nodes and tets as plain numbers on the host. Each of these waits for what the executor was given: on CUDA
// its stream is not the one that arrays are copied in.
#pragma once

#include <fem/mesh/mesh.h>
#include <fem/solver/arrays/solver_arrays.h>

#include <array>
#include <vector>

namespace physgen::fem {

/// @param on whose steps wrote the array. @param array of elasticity::NodePosition in double
template <class On, class Array>
[[nodiscard]] std::vector<Point> points(On& on, const Array& array) {
  on.wait();
  const auto host = moved_to<elasticity::NodePositionArray<double>>(array);
  std::vector<Point> result(static_cast<std::size_t>(host.size()));
  for (index_t n = 0; n < host.size(); ++n) {
    for (int k = 0; k < 3; ++k) result[std::size_t(n)][std::size_t(k)] = host.const_view()[n].x()[k];
  }
  return result;
}

/// @param on whose steps wrote the array. @param array of elasticity::NodeForce in double [N]
template <class On, class Array>
[[nodiscard]] std::vector<Point> plain_forces(On& on, const Array& array) {
  on.wait();
  const auto host = moved_to<elasticity::NodeForceArray<double>>(array);
  std::vector<Point> result(static_cast<std::size_t>(host.size()));
  for (index_t n = 0; n < host.size(); ++n) {
    for (int k = 0; k < 3; ++k) result[std::size_t(n)][std::size_t(k)] = host.const_view()[n].f()[k];
  }
  return result;
}

/// @param on whose steps wrote the array. @param array of elasticity::Stress in double [Pa]. @return by columns
template <class On, class Array>
[[nodiscard]] std::vector<std::array<double, 9>> plain_stresses(On& on, const Array& array) {
  on.wait();
  const auto host = moved_to<elasticity::StressArray<double>>(array);
  std::vector<std::array<double, 9>> result(static_cast<std::size_t>(host.size()));
  for (index_t t = 0; t < host.size(); ++t) {
    for (int k = 0; k < 9; ++k) result[std::size_t(t)][std::size_t(k)] = host.const_view()[t].P()[k];
  }
  return result;
}

}  // namespace physgen::fem
