// The edges of a mesh of few nodes, each at both of its nodes: with a block for each entry of these rows, a product is
// a sum over the row of each node, in a fixed order and without atomics. It reads twice the bytes of the symmetric
// half.
#pragma once

#include <fem/mesh/mesh.h>
#include <physgen/memory/buffer.h>
#include <physgen/memory/space.h>

namespace physgen::fem {

class EdgeRows {
 public:
  /// With so few nodes a product waits longer for its reads than the reading itself takes.
  static constexpr Index most_nodes = 1000;

  /// The view that kernels are given. Entries are numbered as those of TetMesh::node_edges are.
  struct View {
    Index nodes;
    const Index* first;   ///< per node: where its row begins (and one past the last node)
    const Index* others;  ///< per entry: the node at the edge's other end
  };

  /// For no mesh.
  EdgeRows() = default;
  /// @param mesh its edges and node_edges are used
  /// @param space of the lists
  /// @throw Error when the memory cannot be had
  EdgeRows(const TetMesh& mesh, SpaceKind space);

  [[nodiscard]] View view() const;
  [[nodiscard]] bool is_empty() const { return nodes_ == 0; }
  [[nodiscard]] index_t bytes() const { return lists_.bytes(); }
  /// The future bytes().
  [[nodiscard]] static index_t bytes_for(index_t nodes, index_t edges) {
    return (nodes + 1 + 2 * edges) * index_t{sizeof(Index)};
  }

 private:
  Index nodes_ = 0;
  Buffer lists_;
};

}  // namespace physgen::fem
