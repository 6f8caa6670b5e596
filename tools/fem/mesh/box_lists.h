// The lists of a box's mesh by formula. For box_mesh.cpp and boundary.cpp.
#pragma once

#include <fem/mesh/mesh.h>

namespace physgen::fem::detail {

/// Corners of the six tets of a cell that is mirrored along the axes of these bits: bit k of a corner is set where it
/// lies on the upper side along axis k.
[[nodiscard]] std::array<std::array<Index, 4>, 6> tets_of_cell(unsigned mirror);

/// Whether a mesh has the tets that make_box_mesh() makes of its box.
[[nodiscard]] bool has_tets_of_box(const TetMesh& mesh);

/// What make_tet_mesh() finds in the tets of make_box_mesh(): all of the mesh but these.
/// @pre counts are those of the mesh, whose incidences fit 32 bits
void write_box_lists(TetMesh& mesh, Index nx, Index ny, Index nz, const MirroredFrom& mirrored);

}  // namespace physgen::fem::detail
