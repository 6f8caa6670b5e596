// Displacements and velocities of nodes as plain numbers on the host, and back.
#pragma once

#include <dynamics.physgen.h>
#include <fem/mesh/mesh.h>
#include <fem/solver/arrays/solver_arrays.h>

#include <span>
#include <vector>

namespace physgen::fem {

namespace detail {

/// @param vector_of of a view and a number of a node
template <class Host, class Array, class Vector>
[[nodiscard]] std::vector<Point> plain_vectors(const Array& array, const Vector& vector_of) {
  const auto host = moved_to<Host>(array);
  std::vector<Point> result(static_cast<std::size_t>(host.size()));
  for (index_t n = 0; n < host.size(); ++n) {
    const Eigen::Matrix<double, 3, 1> vector = vector_of(host.const_view(), n);
    for (int k = 0; k < 3; ++k) result[std::size_t(n)][std::size_t(k)] = vector[k];
  }
  return result;
}

}  // namespace detail

/// @param array of elasticity::NodeDisplacement in double [m]
template <class Array>
[[nodiscard]] std::vector<Point> plain_displacements(const Array& array) {
  return detail::plain_vectors<elasticity::NodeDisplacementArray<double>>(
      array, [](const auto& view, index_t n) { return view[n].dx().get(); });
}
/// @param array of dynamics::NodeVelocity in double [m/s]
template <class Array>
[[nodiscard]] std::vector<Point> plain_velocities(const Array& array) {
  return detail::plain_vectors<dynamics::NodeVelocityArray<double>>(
      array, [](const auto& view, index_t n) { return view[n].v().get(); });
}

/// Rounds to the array's precision. @param array of elasticity::NodeDisplacement
template <class Array>
void store_displacements(std::span<const Point> vectors, Array& array) {
  elasticity::NodeDisplacementArray<double> host(array.size());
  for (index_t n = 0; n < host.size(); ++n) {
    for (int k = 0; k < 3; ++k) host.view()[n].dx()[k] = vectors[std::size_t(n)][std::size_t(k)];
  }
  copy(array, host);
  synchronize();
}
/// @param array of dynamics::NodeVelocity
template <class Array>
void store_velocities(std::span<const Point> vectors, Array& array) {
  dynamics::NodeVelocityArray<double> host(array.size());
  for (index_t n = 0; n < host.size(); ++n) {
    for (int k = 0; k < 3; ++k) host.view()[n].v()[k] = vectors[std::size_t(n)][std::size_t(k)];
  }
  copy(array, host);
  synchronize();
}

}  // namespace physgen::fem
