// The chunks of tets through which one of several ranks goes, all that it has, ghosts among them.
#pragma once

#include <fem/solver/elastic/tet_chunks.h>
#include <physgen/distributed/arrays.h>
#include <physgen/distributed/local_set.h>
#include <physgen/distributed/transport.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace physgen::fem {

/// How many objects the windows of a rank have: those of a chunk. On CUDA there is one chunk for all, and no window: 0.
/// @tparam Chunk with the arrays of Chunk in solver_groups.h
template <class Chunk>
[[nodiscard]] index_t most_of_window() {
  constexpr SpaceKind space = Chunk::Space::kind;
  return space == SpaceKind::cuda ? 0 : most_chunk_tets(space);
}

/// What a rank has of the tets of materials, and of the volumes of their patches, by its own numbers.
/// @param all by numbers of all; none where there is one material @param tets, volumes that are here
[[nodiscard]] inline std::vector<MaterialRange> materials_of_part(const std::vector<MaterialRange>& all,
                                                                  const LocalSet& tets, const LocalSet* volumes) {
  const auto here = [](const LocalSet& set, index_t number) {  // where the objects from that number on begin
    index_t low = set.first(), high = set.last();
    while (low < high) {
      const index_t middle = low + (high - low) / 2;
      (set.global(middle) < number ? low = middle + 1 : high = middle);
    }
    return low;
  };
  std::vector<MaterialRange> part;
  for (const MaterialRange& range : all) {
    MaterialRange& own =
        part.emplace_back(MaterialRange{here(tets, range.first_tet), here(tets, range.last_tet), 0, 0});
    if (volumes == nullptr) continue;
    own.first_volume = here(*volumes, range.first_volume);
    own.last_volume = here(*volumes, range.last_volume);
  }
  return part;
}

/// The same of the arrays of a body. @pre cut() was called @param all by numbers of all
template <class Body>
[[nodiscard]] std::vector<MaterialRange> materials_of(const DistributedArrays& arrays, Body& body,
                                                      const std::vector<MaterialRange>& all) {
  if (all.empty()) return {};
  const bool averages = body.volumes.size() > 0;
  return materials_of_part(all, arrays.objects_of(body.tets.contents()),
                           averages ? &arrays.objects_of(body.volumes) : nullptr);
}

/// The chunks of a rank's tets, by its own numbers. All ranks have equally many, so that they run the same steps: the
/// first chunks of each material have no tets where another rank has more.
/// @tparam kAssembled whether tangents are assembled at edges @param edges of the level
/// @param materials by the same numbers; none where there is one, as on CUDA
template <bool kAssembled, class Body, class Edges>
[[nodiscard]] std::vector<TetChunk> chunks_of_part(Transport& transport, const Body& body, const Edges& edges,
                                                   const std::vector<MaterialRange>& materials = {}) {
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
    const index_t own = (tets + most - 1) / most;
    const std::vector<index_t> of_each(static_cast<std::size_t>(transport.count()), own);
    const index_t of_all = std::ranges::max(transport.all_to_all(of_each));
    std::vector<TetChunk> chunks;
    for (index_t m = 0; m < std::max<index_t>(static_cast<index_t>(materials.size()), 1); ++m) {
      const MaterialRange range =
          materials.empty() ? MaterialRange{0, tets, 0, 0} : materials[static_cast<std::size_t>(m)];
      chunks.insert(chunks.end(), static_cast<std::size_t>(of_all - own), TetChunk{0, 0, 0, 0, 0, 0, 0, 0, m});
      for (index_t first = 0; first < tets; first += most) {
        const index_t last = std::min(first + most, tets);
        chunks.push_back(make_tet_chunk(range, m, first, last, nodes, all_edges, nodes_of, lower_node_of));
      }
    }
    return chunks;
  }
}

}  // namespace physgen::fem
