// How a tet is deformed, in double, for what is printed and written of a state.
#pragma once

#include <fem/mesh/mesh.h>

#include <Eigen/Dense>
#include <array>

#include "state_windows.h"

namespace physgen::truthcube {

/// Edges from the first corner to the others, by columns [m].
[[nodiscard]] inline Eigen::Matrix3d edges_of(const std::array<fem::Point, 4>& corners) {
  const auto at = [&](std::size_t c) { return Eigen::Vector3d(corners[c][0], corners[c][1], corners[c][2]); };
  Eigen::Matrix3d edges;
  for (int c = 0; c < 3; ++c) edges.col(c) = at(static_cast<std::size_t>(c) + 1) - at(0);
  return edges;
}

[[nodiscard]] inline Eigen::Matrix3d deformation_gradient(const TetState& tet) {
  return edges_of(tet.positions) * edges_of(tet.rest).inverse();
}

}  // namespace physgen::truthcube
