// Rings of nodes: each node and its neighbours, which all move the mean volume of the node's tets.
#pragma once

#include <fem/mesh/mesh.h>

#include <vector>

namespace physgen::fem {

/// The ring of node n is nodes[first[n]] up to, not including, nodes[first[n + 1]], ascending.
struct NodeRings {
  HostList<Index> first;  ///< one more than there are nodes
  HostList<Index> nodes;
};

/// @throws Error when rings have more than 2^31 - 1 nodes in all
[[nodiscard]] NodeRings make_rings(const TetMesh& mesh);

/// The nodes that are in a ring together with a lower one, each once: its neighbours, and those with a neighbour in
/// common. A thread that looks for those of many nodes has one of these.
class HigherInRings {
 public:
  explicit HigherInRings(Index nodes) : seen_from_(static_cast<std::size_t>(nodes), -1) {}
  void find(const NodeRings& rings, Index node);
  [[nodiscard]] const std::vector<Index>& nodes() const { return nodes_; }

 private:
  std::vector<Index> seen_from_, nodes_;
};

/// Pairs (m, n), m < n, ascending, of nodes that are in a ring together.
[[nodiscard]] EdgeList pairs_in_rings(const NodeRings& rings);

}  // namespace physgen::fem
