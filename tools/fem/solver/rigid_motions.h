// The rigid motions that prescribed components leave free.
#pragma once

#include <fem/mesh/mesh.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace physgen::fem {

/// The motions that are free, such as "translation along x" and "rotation about z through (0, 0.01, 0) m"; none where
/// the components hold the body. Rotations are small: what is meant is the rank of the six rigid motions over the
/// prescribed components.
/// @param nodes of the body, or of a part of it that hangs together
/// @param fixed per node: bit k is set where component k is prescribed
[[nodiscard]] std::vector<std::string> free_rigid_motions(std::span<const Index> nodes, std::span<const Point> rest,
                                                          std::span<const std::uint8_t> fixed);

/// @throw Error naming the free motions of the first part of the mesh that is not held
void require_held(const TetMesh& mesh, std::span<const Point> rest, std::span<const std::uint8_t> fixed);

}  // namespace physgen::fem
