// The rigid motions that prescribed components leave free.
#pragma once

#include <fem/mesh/mesh.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace physgen::fem {

inline constexpr std::array<Point, 3> coordinate_axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// The motions that are free, such as "translation along x" and "rotation about z through (0, 0.01, 0) m"; none where
/// the components hold the body. Rotations are small: what is meant is the rank of the six rigid motions over the
/// prescribed components.
/// @param nodes of the body, or of a part of it that hangs together
/// @param fixed per node: bit k is set where component k is prescribed @param axes along which components are counted
[[nodiscard]] std::vector<std::string> free_rigid_motions(std::span<const Index> nodes, std::span<const Point> rest,
                                                          std::span<const std::uint8_t> fixed,
                                                          const std::array<Point, 3>& axes = coordinate_axes);

/// @throw Error naming the free motions of the first part of the mesh that is not held
void require_held(const TetMesh& mesh, std::span<const Point> rest, std::span<const std::uint8_t> fixed,
                  const std::array<Point, 3>& axes = coordinate_axes);

}  // namespace physgen::fem
