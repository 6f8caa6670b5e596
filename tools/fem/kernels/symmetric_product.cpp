// The lists that the symmetric product goes by.
#include <fem/kernels/symmetric_product.h>
#include <physgen/error.h>

#include <string>
#include <vector>

namespace physgen::fem {

EdgeSums::EdgeSums(const TetMesh& mesh, SpaceKind space, int real_bytes, SumOrder order)
    : nodes_(mesh.nodes),
      edges_(static_cast<index_t>(mesh.edges.size())),
      space_(space),
      real_bytes_(real_bytes),
      order_(order) {
  const auto nodes = static_cast<std::size_t>(nodes_);
  std::vector<Index> lists(2 * (nodes + 1) + mesh.edges.size(), 0);
  Index* first = lists.data();
  Index* begin = first + nodes + 1;
  Index* place = begin + nodes + 1;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    if (e > 0 && mesh.edges[e - 1] >= mesh.edges[e]) {
      throw Error("edge " + std::to_string(e) + " of the mesh is not above the one before it; edges (m, n) must be " +
                  "ascending, as make_tet_mesh() makes them");
    }
    if (mesh.edges[e][0] < 0 || mesh.edges[e][0] >= mesh.edges[e][1] || mesh.edges[e][1] >= mesh.nodes) {
      throw Error("edge " + std::to_string(e) + " of the mesh is (" + std::to_string(mesh.edges[e][0]) + ", " +
                  std::to_string(mesh.edges[e][1]) + "); edges (m, n) must have 0 <= m < n < " +
                  std::to_string(mesh.nodes) + ", as make_tet_mesh() makes them");
    }
    ++first[mesh.edges[e][0] + 1];
    ++begin[mesh.edges[e][1] + 1];
  }
  for (std::size_t n = 0; n < nodes; ++n) {
    first[n + 1] += first[n];
    begin[n + 1] += begin[n];
  }
  std::vector<Index> next(begin, begin + nodes);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    place[e] = next[static_cast<std::size_t>(mesh.edges[e][1])]++;
  }
  if (order == SumOrder::any && space == SpaceKind::cuda) return;  // atomics go by no lists
  const auto bytes = static_cast<index_t>(lists.size() * sizeof(Index));
  indices_ = Buffer(space, bytes, "lists of " + std::to_string(edges_) + " edges");
  copy_memory(indices_.data(), space, reinterpret_cast<const std::byte*>(lists.data()), SpaceKind::host, bytes);
  contributions_ = Buffer(space, 4 * edges_ * real_bytes, "contributions of " + std::to_string(edges_) + " edges");
}

void EdgeSums::require(index_t nodes, index_t edges, SpaceKind space, int real_bytes, SumOrder order) const {
  if (order == SumOrder::fixed && order_ == SumOrder::any && space == SpaceKind::cuda) {
    throw Error(
        "a product in SumOrder::fixed was given sums made for SumOrder::any, which have no room for contributions");
  }
  if (nodes == nodes_ && edges == edges_ && space == space_ && real_bytes == real_bytes_) return;
  const auto describe = [](index_t n, index_t e, SpaceKind s, int bytes) {
    return std::to_string(n) + " nodes and " + std::to_string(e) + " edges in " + name(s) + " memory, numbers of " +
           std::to_string(bytes) + " bytes";
  };
  throw Error("a product over " + describe(nodes, edges, space, real_bytes) + " was given sums made for " +
              describe(nodes_, edges_, space_, real_bytes_) + "; make an EdgeSums for it");
}

void detail::require_size(const char* array, index_t size, index_t expected) {
  if (size == expected) return;
  throw Error("a symmetric product over " + std::to_string(expected) + " objects was given " + array + " of " +
              std::to_string(size) + "; resize that array");
}

}  // namespace physgen::fem
