// Volume patches: groups of about six neighbouring tets that share one mean volume change, so that nearly
// incompressible linear tets do not lock (one constraint per patch in the place of one per tet).
#pragma once

#include <fem/mesh/mesh.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace physgen::fem {

/// A partition of a mesh's tets into patches of at most 8 nodes. A patch's nodes lie in its slots, ascending.
struct VolumePatches {
  static constexpr Index max_nodes = 8;

  std::vector<std::array<Index, 8>> nodes;             ///< per patch; unused slots repeat slot 0
  std::vector<Index> node_counts;                      ///< per patch: 4 .. 8 slots in use
  std::vector<Index> tet_patch;                        ///< per tet
  std::vector<std::array<std::uint8_t, 4>> tet_slots;  ///< per tet: nodes[tet_patch[t]][tet_slots[t][c]] is corner c
  IncidenceList patch_tets;                            ///< per patch: tet, its number in the patch (0, 1, ...)
};

/// The cells of a mesh of make_box_mesh(): patch c has tets 6 c .. 6 c + 5 and the 8 corners of cell c, slot
/// i + 2 j + 4 k the corner at (x + i, y + j, z + k).
/// @throws Error when the mesh is numbered in another way; such meshes have greedy_patches()
[[nodiscard]] VolumePatches cell_patches(const TetMesh& box);

/// Patches of any mesh, each connected through faces. A patch starts at the free tet beside earlier patches that has
/// the fewest free neighbours (the one that came there first), or at the lowest free tet; it takes the free neighbour
/// across a face with most of its corners in the patch (the fewest free neighbours, then the lowest number among
/// equals), up to six tets or until each would need a ninth node. Patches of one or two tets then join a neighbour
/// across a face where both have at most 8 nodes together (the fewest nodes, then tets, then the lowest number); where
/// none is, they stay. Measured on boxes and on a mesh of Gmsh, however they are numbered: 5.5 tets per patch, fewer
/// than 1 % of the patches of one or two. The mesh alone decides. Takes linear time, and some 100 bytes per tet for a
/// while.
/// @param material_ends where the tets have several materials, in whose order they lie: for each the number behind its
/// last tet. No patch has tets of two, and patches follow each other as their materials do.
/// @throws Error when a face belongs to more than two tets
[[nodiscard]] VolumePatches greedy_patches(const TetMesh& mesh, std::span<const Index> material_ends = {});

}  // namespace physgen::fem
