// Tets are evaluated a chunk at a time: what one kernel leaves for the next then takes the memory of a chunk, not of
// the mesh, and on CUDA stays in the cache.
#pragma once

#include <fem/numerics/scalar.h>
#include <fem/solver/mesh_level.h>
#include <physgen/config.h>
#include <physgen/kernel.h>
#include <physgen/memory/space.h>

#include <algorithm>
#include <span>
#include <type_traits>
#include <vector>

namespace physgen::fem {

/// The tets of a chunk, and what those of its material touch. Ranges are half-open. The first chunk touches all nodes
/// and edges: it begins their sums. Where there are several materials, each goes through the chunks of all tets, since
/// these begin at whole blocks of a reduction.
struct TetChunk {
  index_t first_tet, last_tet;
  index_t first_node, last_node;
  index_t first_edge, last_edge;
  index_t first_own = first_tet, last_own = last_tet;  ///< those of its material
  index_t material = 0;

  [[nodiscard]] PHYSGEN_FUNCTION bool is_first() const { return first_tet == 0 && material == 0; }
  [[nodiscard]] PHYSGEN_FUNCTION index_t tets() const { return last_tet - first_tet; }
  [[nodiscard]] PHYSGEN_FUNCTION index_t nodes() const { return last_node - first_node; }
  [[nodiscard]] PHYSGEN_FUNCTION index_t edges() const { return last_edge - first_edge; }
  /// Whether a tet is one of its material.
  [[nodiscard]] PHYSGEN_FUNCTION bool has(index_t tet) const { return first_own <= tet && tet < last_own; }
  /// Which of the tets first_tet + i are.
  template <class S, class I>
  [[nodiscard]] PHYSGEN_FUNCTION auto own(const I& i) const {
    static_assert(std::is_same_v<RealOf<S>, double>, "float has no number for each tet of a large chunk");
    const S number = math::to_real<S>(numbers(i));
    return number >= S(RealOf<S>(first_own - first_tet)) && number < S(RealOf<S>(last_own - first_tet));
  }
};

/// The tets of one material, and the patches over which their volumes are averaged. Half-open.
struct MaterialRange {
  index_t first_tet, last_tet;
  index_t first_volume, last_volume;

  [[nodiscard]] PHYSGEN_FUNCTION bool has_tet(index_t tet) const { return first_tet <= tet && tet < last_tet; }
  [[nodiscard]] PHYSGEN_FUNCTION bool has_volume(index_t v) const { return first_volume <= v && v < last_volume; }
};
/// Those of a level; none where the body has one material.
/// @throw Error when a patch has tets of two, or patches do not follow each other as their materials do
[[nodiscard]] std::vector<MaterialRange> material_ranges(const MeshLevel& level);

/// Tets in a chunk, whole blocks of a reduction, so that energies are added as those of one chunk: on CUDA enough to
/// fill the device, on the CPU few enough for its caches.
[[nodiscard]] index_t most_chunk_tets(SpaceKind space);

/// @param edges (m, n), m < n, ascending: of the level, to which the mesh's belong
/// @param most tets in a chunk: a multiple of 2048, above 0
/// @param material_ends as MeshLevel has them
[[nodiscard]] std::vector<TetChunk> make_tet_chunks(const TetMesh& mesh, std::span<const std::array<Index, 2>> edges,
                                                    index_t most, std::span<const Index> material_ends = {});

/// The chunk of tets first .. last-1 of a mesh with so many nodes and edges.
/// @param tets of a material, which is number `material`
/// @param nodes_of nodes_of(tet) gives the numbers of its nodes @param lower_node_of lower_node_of(edge)
template <class NodesOf, class LowerNodeOf>
[[nodiscard]] TetChunk make_tet_chunk(const MaterialRange& tets, index_t material, index_t first, index_t last,
                                      index_t nodes, index_t edges, const NodesOf& nodes_of,
                                      const LowerNodeOf& lower_node_of) {
  const index_t first_own = std::clamp(tets.first_tet, first, last), last_own = std::clamp(tets.last_tet, first, last);
  if (first == 0 && material == 0) return {first, last, 0, nodes, 0, edges, first_own, last_own, material};
  if (first_own == last_own) return {first, last, 0, 0, 0, 0, first_own, last_own, material};
  index_t lowest = nodes, highest = 0;
  for (index_t t = first_own; t < last_own; ++t) {
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
  return {first,     last,     lowest,  highest + 1, first_edge_of(lowest), first_edge_of(highest),
          first_own, last_own, material};
}

}  // namespace physgen::fem
