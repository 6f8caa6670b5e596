#include <fem/mesh/rings.h>
#include <physgen/error.h>

#include <algorithm>
#include <limits>
#include <span>
#include <string>

namespace physgen::fem {

namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

std::span<const Index> ring_of(const NodeRings& rings, Index node) {
  const Index begin = rings.first[at(node)], end = rings.first[at(node) + 1];
  return std::span(rings.nodes).subspan(at(begin), at(end - begin));
}

}  // namespace

NodeRings make_rings(const TetMesh& mesh) {
  const std::size_t entries = at(mesh.nodes) + 2 * mesh.edges.size();
  if (entries > std::size_t{std::numeric_limits<Index>::max()}) {
    throw Error("the rings of " + std::to_string(mesh.nodes) + " nodes would have " + std::to_string(entries) +
                " nodes, but 32-bit numbers only reach 2^31 - 1; use fewer nodes");
  }
  NodeRings rings;
  rings.first.reserve(at(mesh.nodes) + 1);
  rings.first.push_back(0);
  rings.nodes.reserve(entries);
  for (Index n = 0; n < mesh.nodes; ++n) {
    const auto begin = static_cast<std::ptrdiff_t>(rings.nodes.size());
    rings.nodes.push_back(n);
    for (Index k = mesh.node_edges.first[at(n)]; k < mesh.node_edges.first[at(n) + 1]; ++k) {
      const auto [edge, side] = mesh.node_edges.entries[at(k)];
      rings.nodes.push_back(mesh.edges[at(edge)][at(1 - side)]);
    }
    std::sort(rings.nodes.begin() + begin, rings.nodes.end());
    rings.first.push_back(static_cast<Index>(rings.nodes.size()));
  }
  return rings;
}

std::vector<std::array<Index, 2>> pairs_in_rings(const NodeRings& rings) {
  std::vector<std::array<Index, 2>> pairs;
  const auto nodes = static_cast<Index>(rings.first.size()) - 1;
  std::vector<Index> seen_from(at(nodes), -1), others;
  for (Index m = 0; m < nodes; ++m) {
    others.clear();
    for (const Index middle : ring_of(rings, m)) {
      for (const Index n : ring_of(rings, middle)) {
        if (n <= m || seen_from[at(n)] == m) continue;
        seen_from[at(n)] = m;
        others.push_back(n);
      }
    }
    std::ranges::sort(others);
    for (const Index n : others) pairs.push_back({m, n});
  }
  return pairs;
}

}  // namespace physgen::fem
