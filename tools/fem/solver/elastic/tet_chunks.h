// Tets are evaluated a chunk at a time: what one kernel leaves for the next then takes the memory of a chunk, not of
// the mesh, and on CUDA stays in the cache.
#pragma once

#include <fem/solver/mesh_level.h>
#include <physgen/config.h>
#include <physgen/memory/space.h>

#include <algorithm>
#include <span>
#include <vector>

namespace physgen::fem {

/// The tets of a chunk, and what they touch. Ranges are half-open. The first chunk touches all nodes and edges: it
/// begins their sums.
struct TetChunk {
  index_t first_tet, last_tet;
  index_t first_node, last_node;
  index_t first_edge, last_edge;

  [[nodiscard]] PHYSGEN_FUNCTION bool is_first() const { return first_tet == 0; }
  [[nodiscard]] PHYSGEN_FUNCTION index_t tets() const { return last_tet - first_tet; }
  [[nodiscard]] PHYSGEN_FUNCTION index_t nodes() const { return last_node - first_node; }
  [[nodiscard]] PHYSGEN_FUNCTION index_t edges() const { return last_edge - first_edge; }
  [[nodiscard]] PHYSGEN_FUNCTION bool has(index_t tet) const { return first_tet <= tet && tet < last_tet; }
};

/// The tets of one material, and the patches over which their volumes are averaged. Half-open.
struct MaterialRange {
  index_t first_tet, last_tet;
  index_t first_volume, last_volume;

  [[nodiscard]] index_t tets() const { return last_tet - first_tet; }
  [[nodiscard]] index_t volumes() const { return last_volume - first_volume; }
};
/// Those of a level; none where the body has one material.
/// @throw Error when a patch has tets of two, or patches do not follow each other as their materials do
[[nodiscard]] std::vector<MaterialRange> material_ranges(const MeshLevel& level);

/// Tets in a chunk, whole blocks of a reduction, so that energies are added as those of one chunk: on CUDA enough to
/// fill the device, on the CPU few enough for its caches.
[[nodiscard]] index_t most_chunk_tets(SpaceKind space);

/// @param edges (m, n), m < n, ascending: of the level, to which the mesh's belong
/// @param most tets in a chunk: a multiple of 2048, above 0
/// @param material_ends as MeshLevel has them: no chunk has tets of two materials
[[nodiscard]] std::vector<TetChunk> make_tet_chunks(const TetMesh& mesh, std::span<const std::array<Index, 2>> edges,
                                                    index_t most, std::span<const Index> material_ends = {});

/// The chunk of tets first .. last-1 of a mesh with so many nodes and edges.
/// @param nodes_of nodes_of(tet) gives the numbers of its nodes @param lower_node_of lower_node_of(edge)
template <class NodesOf, class LowerNodeOf>
[[nodiscard]] TetChunk make_tet_chunk(index_t first, index_t last, index_t nodes, index_t edges,
                                      const NodesOf& nodes_of, const LowerNodeOf& lower_node_of) {
  if (first == 0) return {first, last, 0, nodes, 0, edges};
  index_t lowest = nodes, highest = 0;
  for (index_t t = first; t < last; ++t) {
    for (const index_t node : nodes_of(t)) {
      lowest = std::min(lowest, node);
      highest = std::max(highest, node);
    }
  }
  const auto first_edge_of = [&](index_t node) {  // edges ascend by their lower node
    index_t low = 0, high = edges;
    while (low < high) {
      const index_t middle = low + (high - low) / 2;
      (lower_node_of(middle) < node ? low = middle + 1 : high = middle);
    }
    return low;
  };
  return {first, last, lowest, highest + 1, first_edge_of(lowest), first_edge_of(highest)};
}

}  // namespace physgen::fem
