// The surface of a body as viewers get it: its triangles, the nodes that they have, and what stands there.
#pragma once

#include <fem/mesh/groups.h>

#include <span>
#include <vector>

#include "output/viewed_mesh.h"

namespace physgen::truthcube {

struct Surface {
  std::vector<fem::Index> nodes;     ///< of the mesh, ascending
  std::vector<fem::Face> triangles;  ///< positions in `nodes`; counter-clockwise, seen from outside
  std::vector<fem::Index> tets;      ///< behind each triangle, the one that has it
};

/// The faces that one tet alone has. @pre a mesh of make_tet_mesh()
[[nodiscard]] Surface surface_of(const fem::TetMesh& mesh);

/// What belongs to the surface, in its order.
[[nodiscard]] std::vector<fem::Point> points_of(const Surface& surface, std::span<const fem::Point> points);
/// Which triangles are of a group, for each that has faces or tets: its faces; of a group without faces, those before
/// its tets. The names are "group_" and the group's, with '_' for '/' and '.', and a number where two are equal then.
[[nodiscard]] std::vector<CellGroup> groups_of(const Surface& surface, std::span<const fem::MeshGroup> groups);

}  // namespace physgen::truthcube
