#include <fem/mesh/at.h>
#include <fem/mesh/rings.h>
#include <fem/mesh/stages.h>
#include <physgen/error.h>
#include <physgen/fill_rows.h>

#include <algorithm>
#include <limits>
#include <span>
#include <string>

namespace physgen::fem {

namespace {

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
  InStage stage("rings");
  NodeRings rings;
  rings.first.resize(at(mesh.nodes) + 1);
  rings.nodes.resize(entries);
  physgen::detail::for_each_index(0, index_t{mesh.nodes} + 1, [&](index_t n) {
    rings.first[at(n)] = mesh.node_edges.first[at(n)] + static_cast<Index>(n);  // a node is in its own ring
  });
  physgen::detail::for_each_index<16>(0, mesh.nodes, [&](index_t n) {
    Index* const ring = rings.nodes.data() + rings.first[at(n)];
    Index* end = ring;
    *end++ = static_cast<Index>(n);
    for (Index k = mesh.node_edges.first[at(n)]; k < mesh.node_edges.first[at(n) + 1]; ++k) {
      const auto [edge, side] = mesh.node_edges.entries[at(k)];
      *end++ = mesh.edges[at(edge)][at(1 - side)];
    }
    physgen::detail::sort_row(ring, end);
  });
  stage.moves(mesh.edges, mesh.node_edges.entries, rings.first, rings.nodes);
  return rings;
}

void HigherInRings::find(const NodeRings& rings, Index node) {
  nodes_.clear();
  for (const Index middle : ring_of(rings, node)) {
    for (const Index other : ring_of(rings, middle)) {
      if (other <= node || seen_from_[at(other)] == node) continue;
      seen_from_[at(other)] = node;
      nodes_.push_back(other);
    }
  }
}

EdgeList pairs_in_rings(const NodeRings& rings) {
  const auto nodes = static_cast<Index>(rings.first.size()) - 1;
  HostList<Index> first;
  EdgeList pairs;
  append_rows(
      Host{}, nodes, [=] { return HigherInRings(nodes); },
      [&](index_t m, HigherInRings& higher, std::vector<std::array<Index, 2>>& row) {
        higher.find(rings, static_cast<Index>(m));
        const std::size_t before = row.size();
        for (const Index n : higher.nodes()) row.push_back({static_cast<Index>(m), n});
        std::sort(row.begin() + static_cast<std::ptrdiff_t>(before), row.end());
      },
      first, pairs);
  return pairs;
}

}  // namespace physgen::fem
