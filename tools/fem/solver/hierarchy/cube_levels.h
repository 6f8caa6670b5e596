// The levels of a cube for several ranks, which make the lists of their parts alone.
#pragma once

#include <fem/solver/mesh_level.h>

#include <cstddef>
#include <vector>

namespace physgen::fem {

/// make_cube_levels() of hierarchy.h, but for the lists of the finest levels.
/// @param without_lists so many have tets alone, and patches that have their nodes alone
[[nodiscard]] std::vector<MeshLevel> make_cube_levels_without_lists(Index cells, double side, bool patches,
                                                                    Index coarsest, std::size_t without_lists);

}  // namespace physgen::fem
