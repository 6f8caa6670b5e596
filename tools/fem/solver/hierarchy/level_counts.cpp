#include <fem/solver/hierarchy/level_counts.h>

#include <numeric>

namespace physgen::fem {

namespace {

template <class List>
std::int64_t size_of(const List& list) {
  return static_cast<std::int64_t>(list.size());
}

}  // namespace

GraphCounts counts_of(const LevelGraph& graph) {
  return {graph.nodes,
          size_of(graph.edges),
          size_of(graph.children.entries),
          graph.edge_terms.first.empty() ? 0 : graph.edge_terms.first.back(),
          size_of(graph.grid_parents),
          graph.is_grid};
}

LevelCounts counts_of(const MeshLevel& level, const LevelGraph& graph) {
  LevelCounts counts{counts_of(graph)};
  counts.tets = size_of(level.mesh.tets);
  counts.tet_edges = size_of(level.mesh.edges);
  counts.patches = size_of(level.patches.nodes);
  for (const std::int64_t nodes : level.patches.node_counts) counts.edge_patches += nodes * (nodes - 1) / 2;
  counts.node_patches =
      std::accumulate(level.patches.node_counts.begin(), level.patches.node_counts.end(), std::int64_t{0});
  counts.patch_parents = size_of(level.patch_parents);
  if (level.averages_at_nodes) counts.ring_nodes = graph.nodes + 2 * counts.tet_edges;
  return counts;
}

std::vector<LevelCounts> count_levels(std::span<const MeshLevel> levels, std::span<const LevelGraph> graphs) {
  std::vector<LevelCounts> counts;
  for (std::size_t l = 0; l < levels.size(); ++l) counts.push_back(counts_of(levels[l], graphs[l]));
  return counts;
}

std::vector<LevelCounts> count_levels(const std::vector<MeshLevel>& levels) {
  return count_levels(levels, make_counted_graphs(levels));
}

}  // namespace physgen::fem
