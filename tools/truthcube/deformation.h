// How a tet is deformed, in double, for what is printed and written of a state.
#pragma once

#include <fem/mesh/mesh.h>

#include <Eigen/Dense>
#include <array>
#include <cstddef>
#include <span>

namespace physgen::truthcube {

/// Edges from the first corner to the others, by columns [m].
[[nodiscard]] inline Eigen::Matrix3d edges_of(const std::array<fem::Index, 4>& tet, std::span<const fem::Point> x) {
  const auto at = [&](std::size_t c) {
    const fem::Point& p = x[static_cast<std::size_t>(tet[c])];
    return Eigen::Vector3d(p[0], p[1], p[2]);
  };
  Eigen::Matrix3d edges;
  for (int c = 0; c < 3; ++c) edges.col(c) = at(static_cast<std::size_t>(c) + 1) - at(0);
  return edges;
}

[[nodiscard]] inline Eigen::Matrix3d deformation_gradient(const std::array<fem::Index, 4>& tet,
                                                          std::span<const fem::Point> rest,
                                                          std::span<const fem::Point> positions) {
  return edges_of(tet, positions) * edges_of(tet, rest).inverse();
}

}  // namespace physgen::truthcube
