// The rows of nodes with their edges.
#include <fem/kernels/edge_rows.h>

#include <string>
#include <vector>

namespace physgen::fem {

EdgeRows::View EdgeRows::view() const {
  const auto* lists = reinterpret_cast<const Index*>(lists_.data());
  return {nodes_, lists, lists + nodes_ + 1};
}

EdgeRows::EdgeRows(const TetMesh& mesh, SpaceKind space) : nodes_(mesh.nodes) {
  std::vector<Index> lists(mesh.node_edges.first.begin(), mesh.node_edges.first.end());
  lists.reserve(lists.size() + mesh.node_edges.entries.size());
  for (const IncidenceEntry& entry : mesh.node_edges.entries) {
    lists.push_back(mesh.edges[static_cast<std::size_t>(entry.element)][static_cast<std::size_t>(1 - entry.local)]);
  }
  const auto bytes = static_cast<index_t>(lists.size() * sizeof(Index));
  lists_ = Buffer(space, bytes, "the rows of " + std::to_string(nodes_) + " nodes");
  copy_memory(lists_.data(), space, reinterpret_cast<const std::byte*>(lists.data()), SpaceKind::host, bytes);
}

}  // namespace physgen::fem
