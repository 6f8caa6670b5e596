// Hierarchies of boxes, and meshes that only look like boxes.
#pragma once

#include <fem/mesh/at.h>
#include <fem/mesh/refine.h>
#include <fem/solver/mesh_level.h>

#include <array>
#include <utility>
#include <vector>

namespace physgen::fem {

/// A hierarchy of boxes. @param cells of the coarsest
inline std::vector<MeshLevel> box_levels(std::array<Index, 3> cells, MirroredFrom mirrored, int refinements,
                                         bool patches) {
  std::vector<MeshLevel> levels;
  for (int k = 0; k <= refinements; ++k) {
    const auto [x, y, z] = cells;
    MeshLevel level;
    if (k > 0) {
      level.parents = box_parents(x, y, z, mirrored);
      for (Index* number : {&cells[0], &cells[1], &cells[2], &mirrored.x, &mirrored.y, &mirrored.z}) {
        if (*number != MirroredFrom::none) *number *= 2;
      }
    }
    level.mesh = make_box_mesh(cells[0], cells[1], cells[2], mirrored);
    level.rest.resize(at(level.mesh.nodes));
    level.fixed.resize(at(level.mesh.nodes));
    if (patches) level.patches = cell_patches(level.mesh);
    levels.insert(levels.begin(), std::move(level));
  }
  return levels;
}

/// Cuts the cell of six tets along another diagonal: mirrors their corners along x within it.
inline void turn_cell(const TetMesh& box, std::size_t first, std::vector<std::array<Index, 4>>& tets) {
  const Index row = box.box->cells[0] + 1;
  const Index cell_x = static_cast<Index>(first / 6) % box.box->cells[0];
  for (std::size_t t = first; t < first + 6; ++t) {
    for (Index& corner : tets[t]) corner += corner % row == cell_x ? 1 : -1;
    std::swap(tets[t][0], tets[t][1]);
  }
}

}  // namespace physgen::fem
