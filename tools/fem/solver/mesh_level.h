// A level of a hierarchy of meshes, as programs give it to the solver: the mesh, and how its nodes hang on the next
// coarser level.
#pragma once

#include <fem/mesh/mesh.h>
#include <fem/mesh/patches.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace physgen::fem {

/// Where a node lies in a tet of a background grid: at the sum of weight times corner. The weights add up to 1.
struct GridLocation {
  std::array<Index, 4> nodes;     ///< numbers on the coarser level; a corner without weight repeats the first
  std::array<double, 4> weights;  ///< 0 where unused
};

/// A mesh on which equilibrium can be solved, or a level of a background grid, which has nodes and no tets. The levels
/// of a hierarchy are nested: the next coarser mesh has a node or the middle of an edge wherever this one has a node;
/// or the next coarser level is a background grid, in whose tets the nodes of this one lie anywhere.
struct MeshLevel {
  TetMesh mesh;
  std::vector<Point> rest;                    ///< [m]
  std::vector<std::uint8_t> fixed;            ///< per node: bit k is set where component k is prescribed
  VolumePatches patches;                      ///< none where the volume is not averaged over them
  std::vector<std::array<Index, 2>> parents;  ///< per node, on the next coarser level; none on the coarsest
  bool averages_at_nodes = false;             ///< the volume, in place of patches
  std::vector<GridLocation> grid_parents;     ///< per node, in place of `parents` where a background grid comes next
  std::vector<Index> patch_parents;           ///< per patch: that of the next coarser level where it lies; or none

  /// Where the body has several materials (SolverSettings::materials), for each the number behind its last tet: tets
  /// lie in the order of their materials. No patch has tets of two.
  std::vector<Index> material_ends;

  /// Directions along which `fixed` counts components, in place of x, y and z: perpendicular to each other, of length 1
  /// and right-handed. Of a hierarchy those of the finest level count. Solvers of equilibria take them.
  std::optional<std::array<Point, 3>> axes;

  [[nodiscard]] bool is_grid() const { return mesh.tets.empty(); }
};

}  // namespace physgen::fem
