// Groups of nodes by which CUDA forms a symmetric product in a fixed order. A thread block has the nodes of a group and
// all edges (m, n) whose first node is one of them. It adds up what these give to each node n, so that one sum is
// stored for each such node instead of a term for each edge.
#pragma once

#include <fem/mesh/mesh.h>
#include <physgen/memory/buffer.h>
#include <physgen/memory/space.h>

#include <cstdint>
#include <span>
#include <vector>

namespace physgen::fem {

/// The lists of all groups. Made once per topology.
class EdgeGroups {
 public:
  static constexpr Index most_nodes = 512;  ///< of a group
  static constexpr int rank_bits = 8;
  static constexpr int stage_edges = 1 << rank_bits;  ///< that a thread block multiplies at a time

  /// The view that kernels are given. A group has a slot for each of its own nodes, then one for each outer node: one
  /// of no lower number, to which its edges lead. Edges of a group are taken in stages, from its first on.
  struct View {
    Index groups = 0;
    Index most_slots = 0;                      ///< of a group
    const Index* first_node = nullptr;         ///< per group (and one past the last)
    const Index* first_outer = nullptr;        ///< per group: where its outer nodes begin (and one past the last)
    const Index* first_edge = nullptr;         ///< per node: the first of its edges as m (and one past the last node)
    const Index* first_sum = nullptr;          ///< per node: where groups' sums for it begin (and one past the last)
    const Index* place = nullptr;              ///< per outer node: the place of its sum
    const std::uint32_t* slot_rank = nullptr;  ///< per edge e of a stage: the slot of the term of rank e, and e's rank
  };

  /// For no mesh.
  EdgeGroups() = default;
  /// @param first_edge per node: the first of its edges as m (and one past the last node)
  /// @param edges (m, n) with m < n, ascending, from first_edge.front() on
  /// @param first_node per group: its first node (and one past the last), ascending, none of more than most_nodes
  /// @throw Error when a group has more nodes or leads to more than its list can number, or the memory cannot be had
  EdgeGroups(std::span<const Index> first_edge, std::span<const std::array<Index, 2>> edges,
             std::span<const Index> first_node, SpaceKind space);

  [[nodiscard]] View view() const;
  /// Sums that all groups store.
  [[nodiscard]] index_t sums() const { return sums_; }
  [[nodiscard]] index_t bytes() const { return lists_.bytes(); }

 private:
  Index nodes_ = 0, groups_ = 0, most_slots_ = 0;
  index_t edges_ = 0, sums_ = 0;
  Buffer lists_;
};

/// How many nodes groups of a mesh have: the same on any number of ranks. Small meshes have groups of fewer, for more
/// thread blocks.
[[nodiscard]] constexpr Index nodes_of_group(index_t nodes) {
  constexpr index_t small = 1 << 16, large = 1 << 17;
  return nodes < small ? 64 : nodes < large ? 256 : EdgeGroups::most_nodes;
}

/// The first nodes of groups, and one past the last, of a part of a mesh: of nodes that are side by side in the whole.
/// @param first, last the nodes that are here
/// @param nodes of the whole mesh
/// @param number number(n) in the whole mesh of node n of the part; ascends
template <class Number>
[[nodiscard]] std::vector<Index> groups_of_part(index_t first, index_t last, index_t nodes, const Number& number) {
  const index_t each = nodes_of_group(nodes);
  std::vector<Index> first_node;
  for (index_t n = first; n < last; ++n) {
    if (n == first || number(n) / each != number(n - 1) / each) first_node.push_back(static_cast<Index>(n));
  }
  first_node.push_back(static_cast<Index>(last));
  return first_node;
}

}  // namespace physgen::fem
