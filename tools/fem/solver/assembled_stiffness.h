// The stiffness of a mesh as plain blocks on the host, for users and tests; and products with it in double.
#pragma once

#include <fem/mesh/mesh.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace physgen::fem {

/// K = df/dx at some positions, negative semidefinite, with the rows and columns of prescribed components: its
/// symmetric half. 3x3 blocks by columns [N/m], in double whatever they were assembled in.
struct AssembledStiffness {
  using Block = std::array<double, 9>;
  std::vector<Block> nodes;                 ///< df(v)/dx(v)
  std::vector<std::array<Index, 2>> edges;  ///< (m, n), m < n, ascending
  std::vector<Block> edge_blocks;           ///< df(m)/dx(n); its transpose is df(n)/dx(m)

  /// K dx. @throw Error when sizes differ
  [[nodiscard]] std::vector<Point> product(std::span<const Point> dx) const;
};

/// |f + K dx| / |f| over free components: how well dx solves K dx = -f. 0 where f is 0 there, and dx, too.
/// @param fixed per node: bit k is set where component k is prescribed
/// @pre dx is 0 in prescribed components
/// @throw Error when sizes differ
[[nodiscard]] double relative_residual(const AssembledStiffness& stiffness, std::span<const std::uint8_t> fixed,
                                       std::span<const Point> f, std::span<const Point> dx);

}  // namespace physgen::fem
