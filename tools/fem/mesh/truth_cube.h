// The Truth Cube (Kerdok et al. 2003): a silicone cube of 8 cm side, compressed between plates; here tetrahedralised,
// and deformed by a smooth field, for measurements that need realistic deformation gradients without solving anything.
#pragma once

#include <fem/mesh/mesh.h>

#include <cstdint>

namespace physgen::fem {

/// Nodes of the cube at rest and compressed, in metres, base in the plane z = 0.
struct TruthCube {
  static constexpr double side = 0.08;          ///< [m]
  static constexpr double compression = 0.125;  ///< plate travel over side

  TetMesh mesh;
  std::vector<Point> rest;
  std::vector<Point> deformed;
};

/// The cube in cells^3 cells of 6 tets. Deformed: compressed by 12.5 % along z, with a lateral bulge that is zero at
/// both plates, greatest half-way up and on average keeps the volume, plus up to 2 % of a cell of seeded noise in each
/// coordinate of nodes between the plates. The same seed gives the same cube on every platform; no tet is inverted.
/// @throws Error as make_box_mesh() does
[[nodiscard]] TruthCube make_truth_cube(Index cells, std::uint64_t seed);

}  // namespace physgen::fem
