// How flat the tets of a mesh are, for smoothers that go node by node.
#pragma once

#include <fem/mesh/mesh.h>

#include <span>

namespace physgen::fem {

/// The flatness of a tet is the cube of its longest edge over six of its volumes, as a multiple of that of a cube's
/// tets, 3 sqrt(3): regular tets have 0.27, those of cells a x a x a/6 have 3.3.
/// @return what 99 of 100 tets do not exceed; 0 of no tets
[[nodiscard]] double flatness(const TetMesh& mesh, std::span<const Point> rest);

}  // namespace physgen::fem
