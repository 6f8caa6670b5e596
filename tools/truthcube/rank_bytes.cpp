#include "rank_bytes.h"

#include <physgen/distributed/runs.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "run_bytes.h"
#include "state_windows.h"

namespace physgen::truthcube {

namespace {

using Members = std::array<std::int64_t LevelCounts::*, 6>;
constexpr Members of_nodes_members{&LevelCounts::nodes,      &LevelCounts::edges,        &LevelCounts::children,
                                   &LevelCounts::edge_terms, &LevelCounts::grid_parents, &LevelCounts::ring_nodes};
constexpr Members of_tets_members{&LevelCounts::tets,         &LevelCounts::tet_edges,    &LevelCounts::patches,
                                  &LevelCounts::edge_patches, &LevelCounts::node_patches, &LevelCounts::patch_parents};

/// Of a level, what a rank has that has these parts of its nodes and of its tets.
LevelCounts part_of(const LevelCounts& whole, double of_nodes, double of_tets) {
  LevelCounts part = whole;
  const auto scale = [](std::int64_t& count, double share) {
    count = static_cast<std::int64_t>(std::ceil(static_cast<double>(count) * std::min(share, 1.0)));
  };
  for (const auto member : of_nodes_members) scale(part.*member, of_nodes);
  for (const auto member : of_tets_members) scale(part.*member, of_tets);
  return part;
}

/// Planes of nodes, and layers of cells, that a rank has beside those that it owns, on each side.
struct Beside {
  double nodes, tets;
};
constexpr Beside ghosts{1.75, 1.25};
constexpr Beside of_lists{5, 5};  // what layers_of_levels.h takes around them, and what is rounded to coarser layers

/// The levels of a rank in the middle, which has ghosts on both sides.
std::vector<LevelCounts> levels_of_rank(const std::vector<LevelCounts>& levels, const RanksOfBytes& ranks,
                                        const Beside& beside) {
  std::vector<LevelCounts> parts = levels;
  const int sides = std::min(ranks.count - 1, 2);
  for (std::size_t l = 0; l < std::min(ranks.cut, levels.size()); ++l) {
    const Runs runs = Runs::of_blocks(levels[l].nodes, ranks.count);
    index_t most = 0;
    for (int r = 0; r < ranks.count; ++r) most = std::max(most, runs.end(r) - runs.begin(r));
    const double owned = static_cast<double>(most) / static_cast<double>(levels[l].nodes);
    const double layer = ranks.cells == 0 ? 0 : 1.0 / (ranks.cells >> l);
    parts[l] = part_of(levels[l], owned + sides * beside.nodes * layer, owned + sides * beside.tets * layer);
  }
  return parts;
}

/// What each rank has of all of a cube's nodes and tets on a level: tets, positions, what is held, how the plate moves,
/// parents, and the nodes of patches.
std::int64_t bytes_of_whole(const LevelCounts& c) {
  constexpr std::int64_t index = sizeof(fem::Index), point = 3 * sizeof(double);
  return 4 * index * c.tets + (2 * point + 1 + 2 * index) * c.nodes + 9 * index * c.patches;
}

/// What the first rank has of a state that it prints and writes.
std::int64_t bytes_of_state(const LevelCounts& finest, std::size_t window, bool sums_groups) {
  constexpr std::int64_t index = sizeof(fem::Index), point = 3 * sizeof(double);
  const WindowSizes windows(window);
  const std::size_t of_windows =
      windows.bytes(static_cast<std::size_t>(finest.nodes), static_cast<std::size_t>(finest.tets));
  // Positions, displacements, forces, loads, and the numbers of all nodes, which are a group.
  const std::int64_t of_groups = sums_groups ? (4 * point + index) * finest.nodes : 0;
  return std::max(static_cast<std::int64_t>(of_windows), of_groups);
}

}  // namespace

RunBytes bytes_of_rank(const std::vector<LevelCounts>& levels, const fem::SolverSettings& settings, RunArrays arrays,
                       const RanksOfBytes& ranks) {
  arrays.on_ranks = true;
  RunBytes bytes = solver_bytes(levels_of_rank(levels, ranks, ghosts), settings, arrays);
  bytes.solver += bytes.stresses;  // which a rank has from the beginning
  bytes.levels.front() += bytes.stresses;
  bytes.stresses = 0;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const bool has_lists = !ranks.has_layers || l >= ranks.cut;
    bytes.meshes += has_lists ? bytes_of_mesh(levels[l]) : bytes_of_whole(levels[l]);
  }
  if (ranks.window) bytes.results = bytes_of_state(levels.front(), *ranks.window, ranks.sums_groups);
  if (!ranks.has_layers) {
    bytes.lists = bytes_of_run(levels, settings, arrays).lists;
    return bytes;
  }
  bytes.lists = bytes_of_run(levels_of_rank(levels, ranks, of_lists), settings, arrays).lists;
  for (std::size_t l = 0; l < std::min(ranks.cut, levels.size()); ++l) bytes.lists += bytes_of_whole(levels[l]);
  return bytes;
}

}  // namespace physgen::truthcube
