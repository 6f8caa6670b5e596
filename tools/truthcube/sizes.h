// How many objects each level of a run will have, before anything of it is allocated.
#pragma once

#include <fem/solver/hierarchy/hierarchy.h>
#include <fem/solver/settings.h>

#include <cstdint>
#include <string>
#include <vector>

#include "options.h"

namespace physgen::truthcube {

/// Numbers of objects of one level, and of the entries of its lists.
struct LevelCounts {
  std::int64_t nodes = 0, tets = 0, edges = 0;  ///< a background grid has no tets; edges are those of the stiffness
  std::int64_t tet_edges = 0;                   ///< edges of tets alone
  std::int64_t patches = 0, edge_patches = 0;   ///< volume patches; pairs of an edge and a patch that has it
  std::int64_t node_patches = 0;                ///< pairs of a node and a patch that has it
  std::int64_t ring_nodes = 0;                  ///< of the rings of all nodes, where volumes are averaged at nodes
  // To the next coarser level; 0 on the coarsest.
  std::int64_t children = 0, edge_terms = 0;
  std::int64_t grid_parents = 0;  ///< nodes with parents in a background grid: all or none
  bool operator==(const LevelCounts&) const = default;
};

/// Counts of the levels that make_cube_levels(cells, ...) would make, without making them: each count is a polynomial
/// of degree 3 in the cells of a side, whose coefficients come from four small cubes, unless the cube itself is small.
/// @pre cells >= 1
[[nodiscard]] std::vector<LevelCounts> count_cube(int cells, VolumeTreatment volume);

/// Counts of given levels. Takes about a third of the solver's set-up.
[[nodiscard]] std::vector<LevelCounts> count_levels(const std::vector<fem::MeshLevel>& levels);

/// The largest number of the solver's lists: of entries, or of an element with its place (fem::PackedEntry). Numbers of
/// 32 bits must hold it.
[[nodiscard]] std::int64_t largest_number(const std::vector<LevelCounts>& levels);

/// @throw Error when numbers of 32 bits do not reach for a cube, with a number of cells that fits
void require_cube_fits(int cells, VolumeTreatment volume);

}  // namespace physgen::truthcube
