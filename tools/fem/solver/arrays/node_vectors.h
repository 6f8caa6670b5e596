// Displacements and velocities of nodes as plain numbers on the host, and back. Each of these waits for what the
// executor was given: on CUDA its stream is not the one that arrays are copied in.
#pragma once

#include <dynamics.physgen.h>
#include <fem/mesh/mesh.h>
#include <fem/solver/arrays/solver_arrays.h>

#include <span>
#include <vector>

namespace physgen::fem {

namespace detail {

/// @param vector_of of a view and a number of a node
template <class Host, class On, class Array, class Vector>
[[nodiscard]] std::vector<Point> plain_vectors(On& on, const Array& array, const Vector& vector_of) {
  on.wait();
  const auto host = moved_to<Host>(array);
  std::vector<Point> result(static_cast<std::size_t>(host.size()));
  for (index_t n = 0; n < host.size(); ++n) {
    const Eigen::Matrix<double, 3, 1> vector = vector_of(host.const_view(), n);
    for (int k = 0; k < 3; ++k) result[std::size_t(n)][std::size_t(k)] = vector[k];
  }
  return result;
}

}  // namespace detail

/// @param on whose steps wrote the array. @param array of elasticity::NodeDisplacement in double [m]
template <class On, class Array>
[[nodiscard]] std::vector<Point> plain_displacements(On& on, const Array& array) {
  return detail::plain_vectors<elasticity::NodeDisplacementArray<double>>(
      on, array, [](const auto& view, index_t n) { return view[n].dx().get(); });
}
/// @param on whose steps wrote the array. @param array of dynamics::NodeVelocity in double [m/s]
template <class On, class Array>
[[nodiscard]] std::vector<Point> plain_velocities(On& on, const Array& array) {
  return detail::plain_vectors<dynamics::NodeVelocityArray<double>>(
      on, array, [](const auto& view, index_t n) { return view[n].v().get(); });
}

/// Rounds to the array's precision. @param on whose steps use the array. @param array of elasticity::NodeDisplacement
template <class On, class Array>
void store_displacements(On& on, std::span<const Point> vectors, Array& array) {
  on.wait();
  elasticity::NodeDisplacementArray<double> host(array.size());
  for (index_t n = 0; n < host.size(); ++n) {
    for (int k = 0; k < 3; ++k) host.view()[n].dx()[k] = vectors[std::size_t(n)][std::size_t(k)];
  }
  copy(array, host);
  synchronize();
}
/// @param on whose steps use the array. @param array of dynamics::NodeVelocity
template <class On, class Array>
void store_velocities(On& on, std::span<const Point> vectors, Array& array) {
  on.wait();
  dynamics::NodeVelocityArray<double> host(array.size());
  for (index_t n = 0; n < host.size(); ++n) {
    for (int k = 0; k < 3; ++k) host.view()[n].v()[k] = vectors[std::size_t(n)][std::size_t(k)];
  }
  copy(array, host);
  synchronize();
}

}  // namespace physgen::fem
