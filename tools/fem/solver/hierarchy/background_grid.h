// Coarser levels for a mesh that has none of its own: a background grid, cells of six Kuhn tets over the box around
// the body, about twice as wide as the mesh is fine, and the same grid in cells twice as wide, and so on.
#pragma once

#include <fem/solver/hierarchy/hierarchy.h>

namespace physgen::fem {

/// Adds levels of a background grid to a hierarchy, if its coarsest mesh has more than most_coarse_nodes nodes. Each
/// node of that mesh hangs on the corners of the grid's tet in which it lies; nodes of the grid on which none hangs are
/// left out. A grid's component is prescribed where it is at all nodes that hang on it.
/// @pre all levels know what is prescribed
/// @return cells along x, y and z of the finest grid; zeros where none is added
/// @throw Error when the mesh has no extent in some direction
std::array<Index, 3> add_background_grid(std::vector<MeshLevel>& levels);

}  // namespace physgen::fem
