// Finer meshes with known parents: every tet into 8. Nodes of the fine mesh are nodes or midpoints of edges of the
// coarse one, so linear interpolation between the two needs the list of parents alone.
#pragma once

#include <fem/mesh/mesh.h>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace physgen::fem {

struct Refined {
  TetMesh mesh;             ///< tets 8 t .. 8 t + 7 fill the coarse tet t
  std::vector<Point> rest;  ///< [m], one per fine node
  /// Per fine node, numbers of coarse nodes: {v, v} for a node v of the coarse mesh, which keeps its number; the two
  /// ends of edge e, ascending, for its midpoint, which is fine node mesh.nodes + e of the coarse mesh.
  std::vector<std::array<Index, 2>> parents;
};

/// Red refinement: four tets at the corners, half as large, and the octahedron between them cut into four around one of
/// its diagonals. All have an eighth of the volume, with the sign of the coarse tet's; the fine mesh is conforming.
/// The corners are taken as a path c0, c1, c2, c3 that runs along one fixed direction in space, whose components are
/// positive; the diagonal joins the midpoints of c0 c2 and c1 c3. Fine tets are paths along it, too, so each tet's
/// descendants have three shapes at most, however often one refines, and the Kuhn mesh of a box becomes that of cells
/// half as wide. Source of the cut: Bey 1995.
/// @throws Error when rest has not mesh.nodes points, or the fine mesh exceeds 32-bit numbers
[[nodiscard]] Refined refine(const TetMesh& mesh, std::span<const Point> rest);

/// The parents that box_parents() gives the node at a place. @param coarse the box with half as many cells
[[nodiscard]] inline std::array<Index, 2> box_parents_at(const BoxCells& coarse, const std::array<Index, 3>& place) {
  // All differences of 0 or 1 in each coordinate are edges of the Kuhn mesh: rounding down and up gives the ends; in
  // mirrored cells up and down.
  const std::array<Index, 3> mirrored{coarse.mirrored.x, coarse.mirrored.y, coarse.mirrored.z};
  Index one = 0, other = 0, distance = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Index up = place[k] / 2 >= mirrored[k] ? 1 : 0;
    one += distance * ((place[k] + up) / 2);
    other += distance * ((place[k] + 1 - up) / 2);
    distance *= coarse.cells[k] + 1;
  }
  return {std::min(one, other), std::max(one, other)};
}

/// Parents of the nodes of make_box_mesh(2 nx, 2 ny, 2 nz) among those of make_box_mesh(nx, ny, nz, mirrored): {v, v}
/// for nodes at the same place, else the two ends, ascending, of the coarse edge whose midpoint the node is.
/// @throws Error as make_box_mesh(2 nx, 2 ny, 2 nz) does
[[nodiscard]] std::vector<std::array<Index, 2>> box_parents(Index nx, Index ny, Index nz,
                                                            const MirroredFrom& mirrored = {});

}  // namespace physgen::fem
