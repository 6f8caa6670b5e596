// The order of edges by slices of nodes.
#include <fem/kernels/edge_slices.h>
#include <physgen/error.h>

#include <algorithm>
#include <numeric>
#include <span>
#include <string>
#include <vector>

namespace physgen::fem {

EdgeSlices::View EdgeSlices::view() const {
  const auto* lists = reinterpret_cast<const Index*>(lists_.data());
  return {nodes_, lists, lists + nodes_ + 1};
}

EdgeSlices::EdgeSlices(const TetMesh& mesh, SpaceKind space) : nodes_(mesh.nodes) {
  if (nodes_ > most_nodes) {
    throw Error("a mesh of " + std::to_string(nodes_) + " nodes; a thread block has room for the edges of " +
                std::to_string(most_nodes));
  }
  const auto nodes = static_cast<std::size_t>(nodes_);
  std::vector<Index> lists(nodes + 1 + mesh.edges.size(), 0);
  const std::span<Index> first(lists.data(), nodes + 1);
  for (const auto& edge : mesh.edges) ++first[static_cast<std::size_t>(edge[0]) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  auto next = lists.begin() + nodes_ + 1;
  for (std::size_t begin = 0; begin < nodes; begin += slice) {
    const std::size_t end = std::min(begin + slice, nodes);
    Index left = first[end] - first[begin];
    for (Index k = 0; left > 0; ++k) {
      for (std::size_t node = begin; node < end; ++node) {
        if (first[node] + k >= first[node + 1]) continue;
        *next++ = mesh.edges[static_cast<std::size_t>(first[node] + k)][1];
        --left;
      }
    }
  }
  const auto bytes = static_cast<index_t>(lists.size() * sizeof(Index));
  lists_ = Buffer(space, bytes, "slices of " + std::to_string(nodes) + " nodes");
  copy_memory(lists_.data(), space, reinterpret_cast<const std::byte*>(lists.data()), SpaceKind::host, bytes);
}

}  // namespace physgen::fem
