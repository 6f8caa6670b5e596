// What one of several ranks has of a mesh: the nodes that it owns, the tets that touch them, and the nodes of others
// that these tets name. Of a box the part is found by formula, so that no rank makes the whole mesh.
#pragma once

#include <fem/mesh/mesh.h>
#include <physgen/distributed/local_set.h>
#include <physgen/distributed/runs.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace physgen::fem {

/// Lists are of global numbers, ascending. Tets follow nodes: each stands in the part of every rank that owns one of
/// its nodes.
struct MeshPart {
  LocalSet nodes;                                 ///< owned nodes, and as ghosts all others that its tets name
  std::vector<Index> tet_numbers;                 ///< of the tets that name an owned node
  std::vector<std::array<Index, 4>> tet_corners;  ///< of these: global numbers of nodes, in the mesh's order

  /// Corners by local numbers of nodes. They ascend where global ones do, so make_tet_mesh() gives edges in the order
  /// of the whole mesh.
  [[nodiscard]] std::vector<std::array<Index, 4>> local_tets() const;
  /// Of the lists above.
  [[nodiscard]] std::int64_t bytes() const;
};

/// Of a mesh all of whose tets are here. Takes linear time in them, and memory for the part alone.
/// @param nodes of the mesh, and which of them each rank owns
/// @throw Error when there is no such rank, or a corner is none of the nodes
[[nodiscard]] MeshPart part_of(std::span<const std::array<Index, 4>> tets, const Runs& nodes, int rank);

/// The same of make_box_mesh(nx, ny, nz, mirrored), of which only the part is made.
/// @throw Error as make_box_mesh(), when the runs are of another number of nodes, or there is no such rank
[[nodiscard]] MeshPart part_of_box(Index nx, Index ny, Index nz, const MirroredFrom& mirrored, const Runs& nodes,
                                   int rank);

}  // namespace physgen::fem
