#include "sizes.h"

#include <fem/solver/packed_rows.h>
#include <physgen/error.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <string>

namespace physgen::truthcube {

namespace {

constexpr std::array members{&LevelCounts::nodes,        &LevelCounts::tets,        &LevelCounts::edges,
                             &LevelCounts::tet_edges,    &LevelCounts::patches,     &LevelCounts::edge_patches,
                             &LevelCounts::node_patches, &LevelCounts::ring_nodes,  &LevelCounts::children,
                             &LevelCounts::edge_terms,   &LevelCounts::grid_parents};

/// The polynomial of degree 3 with these values at 1, 2, 3, 4. Exact: it sums multiples of whole numbers.
std::int64_t extrapolate(std::array<std::int64_t, 4> values, std::int64_t at) {
  for (std::size_t order = 1; order < 4; ++order) {
    for (std::size_t k = 3; k >= order; --k) values[k] -= values[k - 1];  // differences of that order
  }
  const std::int64_t m = at - 1;
  return values[0] + values[1] * m + values[2] * (m * (m - 1) / 2) + values[3] * (m * (m - 1) * (m - 2) / 6);
}

/// Counts of the finest level of cubes with 1 to 4 cells of a side, or with 2, 4, 6 and 8 and a coarser level.
std::array<LevelCounts, 4> small_cubes(VolumeTreatment volume, bool coarser) {
  std::array<LevelCounts, 4> counts;
  for (int m = 1; m <= 4; ++m) {
    const int cells = coarser ? 2 * m : m, coarsest = coarser ? m : cells + 1;
    auto levels = fem::make_cube_levels(cells, 1.0, volume == VolumeTreatment::patches, coarsest);
    for (fem::MeshLevel& level : levels) level.averages_at_nodes = volume == VolumeTreatment::nodes;
    counts[static_cast<std::size_t>(m - 1)] = count_levels(levels).front();
  }
  return counts;
}

std::int64_t entries(const fem::IncidenceList& list) { return static_cast<std::int64_t>(list.entries.size()); }

std::int64_t pairs_in_patches(const fem::VolumePatches& patches) {
  std::int64_t pairs = 0;
  for (const std::int64_t count : patches.node_counts) pairs += count * (count - 1) / 2;
  return pairs;
}

}  // namespace

std::vector<LevelCounts> count_cube(int cells, VolumeTreatment volume) {
  const auto alone = small_cubes(volume, false), above = small_cubes(volume, true);
  std::vector<LevelCounts> levels;
  for (int n = cells;; n /= 2) {
    const bool last = n % 2 != 0 || n / 2 < 2;
    LevelCounts counts;
    for (const auto member : members) {
      std::array<std::int64_t, 4> values{};
      for (std::size_t k = 0; k < 4; ++k) values[k] = last ? alone[k].*member : above[k].*member;
      counts.*member = extrapolate(values, last ? n : n / 2);
    }
    levels.push_back(counts);
    if (last) return levels;
  }
}

std::vector<LevelCounts> count_levels(const std::vector<fem::MeshLevel>& levels) {
  const std::vector<fem::LevelGraph> graphs = fem::make_level_graphs(levels);
  std::vector<LevelCounts> counts;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const fem::MeshLevel& level = levels[l];
    const fem::LevelGraph& graph = graphs[l];
    counts.push_back(
        {graph.nodes, static_cast<std::int64_t>(level.mesh.tets.size()), static_cast<std::int64_t>(graph.edges.size()),
         static_cast<std::int64_t>(level.mesh.edges.size()), static_cast<std::int64_t>(level.patches.nodes.size()),
         pairs_in_patches(level.patches),
         std::accumulate(level.patches.node_counts.begin(), level.patches.node_counts.end(), std::int64_t{0}),
         level.averages_at_nodes ? graph.nodes + 2 * static_cast<std::int64_t>(level.mesh.edges.size()) : 0,
         entries(graph.children), entries(graph.edge_terms), static_cast<std::int64_t>(graph.grid_parents.size())});
  }
  return counts;
}

std::int64_t largest_number(const std::vector<LevelCounts>& levels) {
  const auto packed = [](std::int64_t elements, int bits) { return elements << bits; };
  std::int64_t largest = 0;
  for (const LevelCounts& c : levels) {
    // make_tet_mesh() keeps room for the incidences of tets without common edges: 12 each.
    largest = std::max({largest, 12 * c.tets, 2 * c.edges, c.edge_patches, c.ring_nodes, c.children, c.edge_terms,
                        packed(c.tets, fem::EdgeTetEntry::bits), packed(c.edges, fem::NodeEdgeEntry::bits),
                        packed(c.patches, fem::EdgePatchEntry::bits), packed(c.nodes, fem::ChildEntry::bits)});
    if (c.edge_terms > 0) largest = std::max(largest, packed(c.edges, fem::EdgeTermEntry::bits));
  }
  return largest;
}

void require_cube_fits(int cells, VolumeTreatment volume) {
  constexpr std::int64_t most = std::numeric_limits<fem::Index>::max();
  const std::int64_t largest = largest_number(count_cube(cells, volume));
  if (largest <= most) return;
  int fitting = cells;
  while (largest_number(count_cube(fitting, volume)) > most) {
    fitting -= fitting > 1000 ? fitting / 2 : (fitting % 2 == 0 ? 2 : 1);  // even numbers, which have coarser meshes
  }
  throw Error("--cells " + std::to_string(cells) + ": the solver's lists would need numbers up to " +
              std::to_string(largest) + ", and those of 32 bits reach " + std::to_string(most) + "; --cells " +
              std::to_string(fitting) + " fits");
}

}  // namespace physgen::truthcube
