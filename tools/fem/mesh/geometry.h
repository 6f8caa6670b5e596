// Differences, products and volumes of points, for what is done once per mesh on the host.
#pragma once

#include <fem/mesh/mesh.h>

#include <array>
#include <span>

namespace physgen::fem {

[[nodiscard]] inline Point difference(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

[[nodiscard]] inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

[[nodiscard]] inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Six times the signed volume of a tet: det[x_j - x_i, x_k - x_i, x_l - x_i] [m^3]
[[nodiscard]] inline double six_volumes(const std::array<Index, 4>& tet, std::span<const Point> x) {
  const auto edge = [&](std::size_t corner) {
    return difference(x[static_cast<std::size_t>(tet[corner])], x[static_cast<std::size_t>(tet[0])]);
  };
  return dot(edge(1), cross(edge(2), edge(3)));
}

}  // namespace physgen::fem
