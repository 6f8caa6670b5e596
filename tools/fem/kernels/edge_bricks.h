// The edges of a mesh by bricks of nodes that lie close together, for sums over edges on CUDA: what meets within a
// brick is summed where its thread block works, and only what crosses to another brick takes part in atomics in memory.
// Blocks of edges then lie in an order of their own, in which neighbouring threads read neighbouring blocks.
#pragma once

#include <fem/mesh/mesh.h>
#include <physgen/buffer.h>
#include <physgen/space.h>

#include <array>
#include <vector>

namespace physgen::fem {

class EdgeBricks {
 public:
  static constexpr Index most_nodes = 256;  ///< of a brick
  static constexpr Index few_nodes = 1000;  ///< a mesh of at most so many is one brick
  static constexpr Index slice = 32;        ///< nodes whose edges lie together: the threads of a warp

  /// Whether cycles are faster by bricks: where one thread block has all. Of large levels a product by itself is a
  /// fifth faster by bricks, but no iteration is, and their order costs more than it saves.
  [[nodiscard]] static constexpr bool pay(index_t nodes) { return nodes <= few_nodes; }

  /// What kernels are given. A node has a place in the order of nodes, by which bricks are consecutive; so have slices
  /// of a brick, 32 nodes, the last one fewer. Edges (m, n) belong to m. Those of a slice lie together: the first of
  /// each of its nodes that has one, in order, then the second, and so on.
  struct View {
    Index nodes, bricks;
    const Index* order;   ///< per place: which node
    const Index* begin;   ///< per place: edges of the nodes before it (and one past the last place)
    const Index* first;   ///< per node: its first edge in the mesh's order (and one past the last node)
    const Index* others;  ///< per edge in this order: n, or where n is in m's brick, ~(its place in the brick)

    /// The first place of a brick, or behind the last brick.
    [[nodiscard]] PHYSGEN_FUNCTION Index places_begin(Index brick) const {
      return static_cast<Index>(index_t{brick} * nodes / bricks);
    }
  };

  /// For no mesh.
  EdgeBricks() = default;
  /// @param mesh its edges (m, n) are ascending, as make_tet_mesh() makes them
  /// @param positions of nodes
  /// @param space of the lists
  /// @throw Error when there are not as many positions as nodes, or the memory cannot be had
  EdgeBricks(const TetMesh& mesh, const std::vector<std::array<double, 3>>& positions, SpaceKind space);

  [[nodiscard]] View view() const;
  [[nodiscard]] bool is_empty() const { return nodes_ == 0; }
  [[nodiscard]] index_t bytes() const { return lists_.bytes(); }
  /// What bytes() will be.
  [[nodiscard]] static index_t bytes_for(index_t nodes, index_t edges) {
    return (3 * nodes + 2 + edges) * index_t{sizeof(Index)};
  }

  /// Of the lists that a product reads.
  [[nodiscard]] index_t product_bytes() const { return bytes() - (nodes_ + 1) * index_t{sizeof(Index)}; }

 private:
  Index nodes_ = 0, bricks_ = 1;
  Buffer lists_;
};

}  // namespace physgen::fem
