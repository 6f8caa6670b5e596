#include "run_bytes.h"

#include <fem/solver/preconditioners/all.h>

#include <algorithm>

namespace physgen::truthcube {

namespace {

/// Parents of a level's nodes in a MeshLevel, or in a LevelGraph.
std::int64_t bytes_of_parents(const LevelCounts& c) {
  if (c.children == 0) return 0;
  return c.grid_parents * std::int64_t{sizeof(fem::GridLocation)} +
         (c.nodes - c.grid_parents) * 2 * std::int64_t{sizeof(fem::Index)};
}

constexpr std::int64_t index_bytes = sizeof(fem::Index), entry_bytes = sizeof(fem::IncidenceEntry);

std::int64_t bytes_of_list(std::int64_t rows, std::int64_t entries) {
  return index_bytes * (rows + 1) + entry_bytes * entries;
}

/// A LevelGraph.
std::int64_t bytes_of_graph(const LevelCounts& c, const LevelCounts* coarser, bool edges) {
  if (!edges) return c.nodes + (coarser == nullptr ? 0 : 2 * index_bytes * c.nodes);
  const std::int64_t bytes = 2 * index_bytes * c.edges + bytes_of_list(c.nodes, 2 * c.edges) + c.nodes;
  if (coarser == nullptr) return bytes;
  // Terms of coarse blocks are written into the solver's arrays; of their list there are the rows.
  return bytes + bytes_of_parents(c) + bytes_of_list(coarser->nodes, c.children) + bytes_of_list(coarser->edges, 0);
}

}  // namespace

std::int64_t bytes_of_mesh(const LevelCounts& c) {
  const std::int64_t real = sizeof(double);
  std::int64_t bytes = 4 * index_bytes * c.tets + 2 * index_bytes * c.tet_edges + bytes_of_list(c.nodes, 4 * c.tets) +
                       bytes_of_list(c.nodes, 2 * c.tet_edges) + bytes_of_list(c.tet_edges, 6 * c.tets) +
                       3 * real * c.nodes + c.nodes + bytes_of_parents(c);
  if (c.patches > 0) {
    bytes += 10 * index_bytes * c.patches + (index_bytes + 4) * c.tets + bytes_of_list(c.patches, c.tets);
  }
  return bytes;
}

RunBytes bytes_of_run(const std::vector<LevelCounts>& levels, const fem::SolverSettings& settings,
                      const RunArrays& arrays) {
  RunBytes bytes = solver_bytes(levels, settings, arrays);
  const bool assembled = settings.newton.product == fem::Product::assembled;
  // Of the graphs, the edges stay until all arrays are made, and the rest until those of the levels are.
  std::int64_t graphs = 0, edges = 0;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const LevelCounts* coarser = l + 1 < levels.size() ? &levels[l + 1] : nullptr;
    bytes.lists += bytes_of_mesh(levels[l]);
    graphs += bytes_of_graph(levels[l], coarser, assembled);
    if (assembled) edges += 2 * index_bytes * levels[l].edges;
  }
  const LevelCounts& finest = levels.front();
  if (arrays.scene == SceneKind::explicit_dynamics) return bytes;  // whose lists are those of the mesh
  graphs += fem::with_preconditioner(settings.newton.preconditioner.kind, [&]<class Type>() {
    return Type::template bytes<fem::NoArrays>(finest.nodes, finest.edges).lists;
  });
  std::int64_t parts = bytes_of_list(finest.nodes, finest.node_patches);
  if (assembled) {
    parts += bytes_of_list(finest.edges, 0) + bytes_of_list(finest.edges, finest.edge_patches);  // tets: the mesh's
  }
  if (finest.ring_nodes > 0) parts += index_bytes * (finest.nodes + 1 + finest.ring_nodes);
  bytes.lists += std::max(graphs, edges + parts);
  return bytes;
}

}  // namespace physgen::truthcube
