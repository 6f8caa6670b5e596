#include <fem/mesh/at.h>
#include <fem/solver/hierarchy/box_levels.h>
#include <fem/solver/hierarchy/hierarchy.h>
#include <fem/solver/levels/layers_of_levels.h>
#include <physgen/distributed/runs.h>
#include <physgen/error.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

namespace physgen::fem {

namespace {

/// Layers of cells along z: first .. last-1.
struct CellLayers {
  Index first, last;
};

index_t nodes_of_layer(const BoxCells& box) { return index_t{box.cells[0] + 1} * (box.cells[1] + 1); }
index_t cells_of_layer(const BoxCells& box) { return index_t{box.cells[0]} * box.cells[1]; }

bool are_levels_of_a_box(std::span<const MeshLevel> levels) {
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const MeshLevel& level = levels[l];
    const bool is_plain = !level.averages_at_nodes && level.material_ends.empty() && level.grid_parents.empty();
    if (!is_plain || !detail::has_tets_of_box(level.mesh)) return false;
    if (!level.patches.nodes.empty() && !detail::has_cell_patches(level)) return false;
    if (l + 1 == levels.size()) break;
    const std::optional<BoxCells>& coarser = levels[l + 1].mesh.box;
    if (!coarser || !detail::has_parents_of_box(*level.mesh.box, *coarser, level.parents)) return false;
  }
  return true;
}

/// The layers of the finest level that a rank needs which owns a run of the nodes of each that is cut: these, and
/// around them what its objects lead to. They are layers of the coarsest, too.
CellLayers layers_of_rank(std::span<const MeshLevel> levels, std::size_t cut, int rank, int ranks) {
  // A run of objects that follow nodes may have half a block of others. What these lead to lies in cells around them,
  // and lists are complete where there is one cell more.
  constexpr index_t around = 3;
  const index_t all = levels.front().mesh.box->cells[2], step = index_t{1} << (levels.size() - 1);
  index_t first = all, last = 0;
  for (std::size_t l = 0; l < cut; ++l) {
    const BoxCells& box = *levels[l].mesh.box;
    const Runs runs = Runs::of_blocks(levels[l].mesh.nodes, ranks);
    const index_t begin = runs.begin(rank), end = std::max(runs.end(rank), begin + 1);
    const index_t layer = nodes_of_layer(box), cells = cells_of_layer(box);
    const index_t more = around + (Runs::block / 2 + cells - 1) / cells;
    first = std::min(first, (begin / layer - more) * (index_t{1} << l));
    last = std::max(last, ((end - 1) / layer + more) << l);
  }
  first = std::max(first, index_t{0}) / step * step;
  last = std::min((last + step - 1) / step * step, all);
  return {static_cast<Index>(std::min(first, all - step)), static_cast<Index>(last)};
}

template <class T>
std::vector<T> slice(const std::vector<T>& all, index_t first, index_t size) {
  if (all.empty()) return {};
  return {all.begin() + first, all.begin() + first + size};
}

MeshLevel level_between(const MeshLevel& whole, const CellLayers& layers, bool has_coarser) {
  const BoxCells& box = *whole.mesh.box;
  const auto& [nx, ny, all] = box.cells;
  const Index nz = layers.last - layers.first;
  MirroredFrom mirrored = box.mirrored;
  if (mirrored.z != MirroredFrom::none) mirrored.z = std::max(mirrored.z - layers.first, Index{0});
  MeshLevel level;
  level.mesh = make_box_mesh(nx, ny, nz, mirrored);
  const index_t nodes = nodes_of_layer(box), cells = cells_of_layer(box);
  level.rest = slice(whole.rest, nodes * layers.first, level.mesh.nodes);
  level.fixed = slice(whole.fixed, nodes * layers.first, level.mesh.nodes);
  if (!whole.patches.nodes.empty()) level.patches = cell_patches(level.mesh);
  if (!has_coarser) return level;
  const auto half = [](Index from) { return from == MirroredFrom::none ? from : from / 2; };
  level.parents = box_parents(nx / 2, ny / 2, nz / 2, {half(mirrored.x), half(mirrored.y), half(mirrored.z)});
  level.patch_parents = slice(whole.patch_parents, cells * layers.first, cells * nz);
  const auto before = static_cast<Index>(cells / 4 * (layers.first / 2));
  for (Index& patch : level.patch_parents) patch -= before;
  return level;
}

/// @param graph of the layers of a level
ListedLevel listed_between(const MeshLevel& level, const CellLayers& layers, const LevelGraph& graph) {
  const BoxCells& box = *level.mesh.box;
  const index_t nodes = nodes_of_layer(box), cells = cells_of_layer(box), all = box.cells[2];
  const index_t height = layers.last - layers.first;
  const auto edges_before = [&](index_t layer) {
    const auto found =
        std::ranges::lower_bound(graph.edges, nodes * layer, {}, [](const auto& edge) { return index_t{edge[0]}; });
    return static_cast<index_t>(found - graph.edges.begin());
  };
  // As many begin in all layers of nodes but the last.
  const index_t edges = edges_before(1), of_last = static_cast<index_t>(graph.edges.size()) - edges_before(height);
  // Beside layers that are left out, nodes lack cells, and so do edges that end there.
  const index_t below = layers.first == 0 ? 0 : 1, above = layers.last == all ? 0 : 1;
  const auto run = [&](index_t of_layer, index_t end) {
    return ListedObjects{0, of_layer * layers.first, {of_layer * layers.first, of_layer * layers.first + end}};
  };
  ListedLevel listed{run(nodes, nodes * (height + 1 - above)), run(edges, edges_before(height + 1 - 2 * above)),
                     run(6 * cells, 6 * cells * height), run(cells, cells * height)};
  listed.nodes.known.first += nodes * below;
  listed.edges.known.first += edges * below;
  listed.nodes.size = nodes * (all + 1);
  listed.edges.size = edges * all + of_last;
  listed.tets.size = 6 * cells * all;
  listed.patches.size = level.patches.nodes.empty() ? 0 : cells * all;
  return listed;
}

ListedLevel listed_whole(const MeshLevel& level, const LevelGraph& graph) {
  ListedLevel listed = listed_whole(graph);
  listed.tets.size = static_cast<index_t>(level.mesh.tets.size());
  listed.patches.size = static_cast<index_t>(level.patches.nodes.size());
  return listed;
}

/// The edges of the layers of a level are those that the whole has there.
void require_edges(const LevelGraph& between, const ListedLevel& listed, const LevelGraph& whole) {
  bool are_same = listed.edges.size == static_cast<index_t>(whole.edges.size());
  for (index_t e = listed.edges.known.first; are_same && e < listed.edges.known.last; ++e) {
    const auto& [m, n] = between.edges[at(listed.edges.here(e))];
    are_same = whole.edges[at(e)] ==
               std::array{static_cast<Index>(m + listed.nodes.offset), static_cast<Index>(n + listed.nodes.offset)};
  }
  if (!are_same) throw Error("the layers of a coarser level have other edges than the whole; give the levels of a box");
}

void require_lists(std::span<const MeshLevel> levels, const char* reason) {
  const auto lacks = [](const MeshLevel& level) { return !level.is_grid() && level.mesh.node_tets.first.empty(); };
  if (std::ranges::none_of(levels, lacks)) return;
  throw Error(std::string("levels have no lists, and need them since ") + reason +
              "; give meshes that make_tet_mesh() made");
}

}  // namespace

std::size_t levels_cut_by_solver(std::span<const index_t> nodes, const SolverSettings& settings, int ranks,
                                 std::optional<index_t> replicated) {
  const std::size_t used = used_levels(settings, nodes.size(), nodes.size()).used;
  std::vector<LevelGraph> graphs(used);
  for (std::size_t l = 0; l < used; ++l) graphs[l].nodes = static_cast<Index>(nodes[l]);
  return levels_that_are_cut(graphs, ranks, replicated);
}

PartOfLevels part_of_levels(std::span<const MeshLevel> levels, std::size_t cut, int rank, int ranks, bool edges) {
  PartOfLevels part;
  const auto of_parts = levels.first(std::min(cut + 1, levels.size()));
  if (!are_levels_of_a_box(of_parts)) {
    require_lists(levels, "they are no levels of a box");
    part.graphs = make_level_graphs(levels, edges);
    for (std::size_t l = 0; l < levels.size(); ++l)
      part.listed.levels.push_back(listed_whole(levels[l], part.graphs[l]));
    part.listed.coarser.assign(part.listed.levels.begin() + 1, part.listed.levels.end());
    return part;
  }
  const CellLayers finest = layers_of_rank(of_parts, cut, rank, ranks);
  const auto layers_of = [&](std::size_t l) { return CellLayers{finest.first >> l, finest.last >> l}; };
  for (std::size_t l = 0; l < of_parts.size(); ++l) {
    part.levels.push_back(level_between(levels[l], layers_of(l), l + 1 < of_parts.size()));
  }
  part.graphs = make_level_graphs(part.levels, edges);
  for (std::size_t l = 0; l < of_parts.size(); ++l) {
    part.listed.levels.push_back(listed_between(levels[l], layers_of(l), part.graphs[l]));
  }
  part.listed.coarser.assign(part.listed.levels.begin() + 1, part.listed.levels.end());
  if (cut >= levels.size()) return part;
  // All ranks have the whole of the others.
  require_lists(levels.subspan(cut), "they are not cut");
  std::vector<LevelGraph> whole = make_level_graphs(levels.subspan(cut), edges);
  require_edges(part.graphs[cut], part.listed.levels[cut], whole.front());
  part.levels.pop_back();
  part.graphs.pop_back();
  part.listed.levels.pop_back();
  for (std::size_t l = cut; l < levels.size(); ++l) {
    part.graphs.push_back(std::move(whole[l - cut]));
    part.listed.levels.push_back(listed_whole(levels[l], part.graphs[l]));
    if (l > cut) part.listed.coarser.push_back(part.listed.levels[l]);
  }
  return part;
}

}  // namespace physgen::fem
