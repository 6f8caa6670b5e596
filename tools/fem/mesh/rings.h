// Rings of nodes: each node and its neighbours, which all move the mean volume of the node's tets.
#pragma once

#include <fem/mesh/mesh.h>

#include <array>
#include <vector>

namespace physgen::fem {

/// The ring of node n is nodes[first[n]] up to, not including, nodes[first[n + 1]], ascending.
struct NodeRings {
  std::vector<Index> first;  ///< one more than there are nodes
  std::vector<Index> nodes;
};

/// @throws Error when rings have more than 2^31 - 1 nodes in all
[[nodiscard]] NodeRings make_rings(const TetMesh& mesh);

/// Pairs (m, n), m < n, ascending, of nodes that are in a ring together: neighbours, and those with a neighbour in
/// common.
[[nodiscard]] std::vector<std::array<Index, 2>> pairs_in_rings(const NodeRings& rings);

}  // namespace physgen::fem
