// How many objects each level of a run will have, before anything of it is allocated.
#pragma once

#include <fem/solver/hierarchy/level_counts.h>
#include <fem/solver/settings.h>

#include <cstdint>
#include <string>
#include <vector>

#include "options.h"

namespace physgen::truthcube {

using fem::count_levels;
using fem::LevelCounts;

/// Counts of the levels that make_cube_levels(cells, ...) would make, without making them: each count is a polynomial
/// of degree 3 in the cells of a side, whose coefficients come from four small cubes, unless the cube itself is small.
/// @pre cells >= 1
[[nodiscard]] std::vector<LevelCounts> count_cube(int cells, VolumeTreatment volume);

/// The largest number of the solver's lists: of entries, or of an element with its place (fem::PackedEntry). Numbers of
/// 32 bits must hold it.
[[nodiscard]] std::int64_t largest_number(const std::vector<LevelCounts>& levels);

/// Counts of the levels of a mesh. The graphs that it makes for that become those of the solver's settings, so that the
/// solver makes no others, unless the run has no use for them.
/// @throw Error as require_mesh_fits()
[[nodiscard]] std::vector<LevelCounts> count_mesh(const std::vector<fem::MeshLevel>& levels, Options& options);

/// @throw Error when numbers of 32 bits do not reach for the levels of a mesh
void require_mesh_fits(const std::vector<LevelCounts>& levels);

/// @throw Error when numbers of 32 bits do not reach for a cube, with a number of cells that fits
void require_cube_fits(int cells, VolumeTreatment volume);

}  // namespace physgen::truthcube
