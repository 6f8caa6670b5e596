// The chunks of tets through which one of several ranks goes, all that it has, ghosts among them.
#pragma once

#include <fem/solver/elastic/tet_chunks.h>
#include <physgen/distributed/transport.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace physgen::fem {

/// Objects of the windows of a rank: those of a chunk. On CUDA there is one chunk for all, and no window.
/// @tparam Chunk with the arrays of Chunk in solver_groups.h
template <class Chunk>
[[nodiscard]] index_t most_of_window() {
  constexpr SpaceKind space = Chunk::Space::kind;
  return space == SpaceKind::cuda ? 0 : most_chunk_tets(space);
}

/// Of the arrays of a rank, by its own numbers. All ranks have as many chunks, so that they run the same steps: the
/// first have no tets where another rank has more.
/// @tparam kAssembled whether tangents are assembled at edges @param edges of the level
template <bool kAssembled, class Body, class Edges>
[[nodiscard]] std::vector<TetChunk> chunks_of_part(Transport& transport, const Body& body, const Edges& edges) {
  const index_t tets = body.tets.size(), nodes = body.rest.size();
  if constexpr (Body::Space::kind == SpaceKind::cuda) {
    return {{0, tets, 0, nodes, 0, edges.size()}};
  } else {
    const index_t most = most_chunk_tets(Body::Space::kind);
    const auto nodes_of = [view = body.tets.const_view()](index_t tet) {
      const auto named = view[tet].nodes();
      return std::array<index_t, 4>{named[0], named[1], named[2], named[3]};
    };
    const auto lower_node_of = [&edges](index_t edge) -> index_t {
      if constexpr (kAssembled) return edges.const_view()[edge].nodes()[0];
      return edge;  // of none
    };
    const index_t all_edges = kAssembled ? edges.size() : 0;
    std::vector<TetChunk> chunks;
    for (index_t first = 0; first < tets; first += most) {
      const index_t last = std::min(first + most, tets);
      chunks.push_back(make_tet_chunk(first, last, nodes, all_edges, nodes_of, lower_node_of));
    }
    const std::vector<index_t> own(static_cast<std::size_t>(transport.count()), static_cast<index_t>(chunks.size()));
    const index_t of_all = std::ranges::max(transport.all_to_all(own));
    chunks.insert(chunks.begin(), static_cast<std::size_t>(of_all) - chunks.size(), TetChunk{0, 0, 0, 0, 0, 0});
    return chunks;
  }
}

}  // namespace physgen::fem
