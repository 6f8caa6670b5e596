// The edges of a mesh of few nodes in the order in which one thread block on CUDA takes them: neighbouring threads have
// neighbouring nodes, read neighbouring blocks of edges, and add to different nodes in shared memory.
#pragma once

#include <fem/mesh/mesh.h>
#include <physgen/buffer.h>
#include <physgen/space.h>

namespace physgen::fem {

class EdgeSlices {
 public:
  static constexpr Index most_nodes = 1000;  ///< for which a thread block has room
  static constexpr Index slice = 32;         ///< nodes whose edges lie together: the threads of a warp

  /// The view that kernels are given. Edges (m, n) belong to m. Those of a slice lie together: the first of each of its
  /// nodes that has one, in order, then the second, and so on.
  struct View {
    Index nodes;
    const Index* first;   ///< per node: edges of the nodes before it (and one past the last node)
    const Index* others;  ///< per edge in this order: n
  };

  /// For no mesh.
  EdgeSlices() = default;
  /// @param mesh its edges (m, n) are ascending, as make_tet_mesh() makes them
  /// @param space of the lists
  /// @throw Error when there are more than most_nodes nodes, or the memory cannot be had
  EdgeSlices(const TetMesh& mesh, SpaceKind space);

  [[nodiscard]] View view() const;
  [[nodiscard]] bool is_empty() const { return nodes_ == 0; }
  [[nodiscard]] index_t bytes() const { return lists_.bytes(); }
  /// The future bytes().
  [[nodiscard]] static index_t bytes_for(index_t nodes, index_t edges) {
    return (nodes + 1 + edges) * index_t{sizeof(Index)};
  }

 private:
  Index nodes_ = 0;
  Buffer lists_;
};

}  // namespace physgen::fem
