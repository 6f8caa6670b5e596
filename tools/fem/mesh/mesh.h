// Tetrahedral meshes as plain index lists: tets, edges, and the incidence lists that turn sums over elements into
// gathers (so that they are deterministic and need no atomics).
#pragma once

#include <physgen/memory/host_list.h>

#include <array>
#include <compare>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace physgen::fem {

/// Node, tet and edge numbers: 32 bit, as the kernels read them.
using Index = std::int32_t;

/// A position [m].
using Point = std::array<double, 3>;

/// The two corners of each local edge of a tet, in the order all lists use.
inline constexpr std::array<std::array<int, 2>, 6> tet_edges{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// One element that touches an object: which element, and where in it.
struct IncidenceEntry {
  Index element, local;
  auto operator<=>(const IncidenceEntry&) const = default;
};

/// For every object of one kind, what touches it: entries[first[i]] up to, not including, entries[first[i + 1]],
/// ascending.
struct IncidenceList {
  HostList<Index> first;  ///< one more than there are objects
  HostList<IncidenceEntry> entries;
  bool operator==(const IncidenceList&) const = default;
};

/// The ends of edges (m, n), m < n, ascending.
using EdgeList = HostList<std::array<Index, 2>>;

/// The cells of a box that are cut as the mirror images of those before them: from this number on along each axis.
struct MirroredFrom {
  static constexpr Index none = std::numeric_limits<Index>::max();
  Index x = none, y = none, z = none;
  bool operator==(const MirroredFrom&) const = default;
};

/// A box of cells: how many along each axis, and which are mirrored.
struct BoxCells {
  std::array<Index, 3> cells{};
  MirroredFrom mirrored;
  bool operator==(const BoxCells&) const = default;
};

struct TetMesh {
  Index nodes = 0;
  std::vector<std::array<Index, 4>> tets;  ///< corners i, j, k, l; det[x_j-x_i, x_k-x_i, x_l-x_i] > 0 at rest
  EdgeList edges;
  IncidenceList node_tets;   ///< tet, corner
  IncidenceList node_edges;  ///< edge, side; side 0: the node is m, side 1: it is n
  IncidenceList edge_tets;   ///< tet, local edge, + 6 if the tet has the edge as (n, m)
  /// What make_box_mesh() made it of. Lists may have been changed since: who goes by it checks those that it reads.
  std::optional<BoxCells> box = std::nullopt;
};

/// Edges and incidence lists of the given tets.
/// @throws Error when a corner is not in [0, nodes), a tet names a node twice, or a list would exceed 2^31 entries
[[nodiscard]] TetMesh make_tet_mesh(Index nodes, std::vector<std::array<Index, 4>> tets);

/// Per node, its edges of an ascending list: edge, side. The entries of a node are those that TetMesh::node_edges has.
[[nodiscard]] IncidenceList edges_of_nodes(Index nodes, std::span<const std::array<Index, 2>> edges);

/// A box of nx * ny * nz cells, each cut into the 6 tets around its main diagonal (Kuhn, Freudenthal): conforming, all
/// of one volume. Node (x, y, z) has number x + (nx + 1) (y + (ny + 1) z). Diagonals run from the lowest to the highest
/// corner, so a body that nothing holds sideways drifts to one side, unless the box is its own mirror image: with half
/// of the cells mirrored along each axis, diagonals run from the corners of the box towards its centre.
/// @throws Error when a count is below 1 or the mesh exceeds 2^31 incidences
[[nodiscard]] TetMesh make_box_mesh(Index nx, Index ny, Index nz, const MirroredFrom& mirrored = {});

}  // namespace physgen::fem
