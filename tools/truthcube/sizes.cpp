#include "sizes.h"

#include <fem/solver/arrays/packed_rows.h>
#include <physgen/error.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <string>
#include <utility>

namespace physgen::truthcube {

namespace {

constexpr std::array<std::int64_t LevelCounts::*, 12> members{
    &LevelCounts::nodes,        &LevelCounts::edges,        &LevelCounts::children,      &LevelCounts::edge_terms,
    &LevelCounts::grid_parents, &LevelCounts::tets,         &LevelCounts::tet_edges,     &LevelCounts::patches,
    &LevelCounts::edge_patches, &LevelCounts::node_patches, &LevelCounts::patch_parents, &LevelCounts::ring_nodes};

/// The polynomial of degree 3 with these values at 1, 2, 3, 4. Exact: it sums multiples of whole numbers.
std::int64_t extrapolate(std::array<std::int64_t, 4> values, std::int64_t at) {
  for (std::size_t order = 1; order < 4; ++order) {
    for (std::size_t k = 3; k >= order; --k) values[k] -= values[k - 1];  // differences of that order
  }
  const std::int64_t m = at - 1;
  return values[0] + values[1] * m + values[2] * (m * (m - 1) / 2) + values[3] * (m * (m - 1) * (m - 2) / 6);
}

std::vector<fem::MeshLevel> make_levels(int cells, VolumeTreatment volume, int coarsest) {
  auto levels = fem::make_cube_levels(cells, 1.0, volume == VolumeTreatment::patches, coarsest);
  for (fem::MeshLevel& level : levels) level.averages_at_nodes = volume == VolumeTreatment::nodes;
  return levels;
}

/// Cells of a side from which on counts are polynomials. Neighbours in rings are two cells apart, and what is counted
/// near a face of the cube must not be near where its cells begin to be mirrored.
int first_cells(VolumeTreatment volume) { return volume == VolumeTreatment::nodes ? 8 : 1; }

/// The counts from which those of all larger cubes follow.
struct SmallCubes {
  int first;  ///< cells of a side of the first, or of its coarser level; each has one more than the one before
  std::array<LevelCounts, 4> alone, above;  ///< of the finest level, without and with a coarser one
};

SmallCubes count_small_cubes(VolumeTreatment volume) {
  SmallCubes small{first_cells(volume), {}, {}};
  for (std::size_t k = 0; k < 4; ++k) {
    const int m = small.first + static_cast<int>(k);
    small.alone[k] = count_levels(make_levels(m, volume, m + 1)).front();
    small.above[k] = count_levels(make_levels(2 * m, volume, m)).front();
  }
  return small;
}

/// Cells of a side up to which cubes are made to be counted.
int most_made(VolumeTreatment volume) {
  const int first = first_cells(volume);
  return first == 1 ? 0 : 2 * (first + 3);
}

std::vector<LevelCounts> count_cube(int cells, VolumeTreatment volume, const SmallCubes& small) {
  std::vector<LevelCounts> levels;
  for (int n = cells; n > most_made(volume); n /= 2) {
    const bool last = n % 2 != 0 || n / 2 < 2;
    LevelCounts counts;
    for (const auto member : members) {
      std::array<std::int64_t, 4> values{};
      for (std::size_t k = 0; k < 4; ++k) values[k] = (last ? small.alone : small.above)[k].*member;
      counts.*member = extrapolate(values, (last ? n : n / 2) - small.first + 1);
    }
    levels.push_back(counts);
    if (last) return levels;
  }
  const int left = cells >> levels.size();
  const std::vector<LevelCounts> made = count_levels(make_levels(left, volume, 2));
  levels.insert(levels.end(), made.begin(), made.end());
  return levels;
}

}  // namespace

std::vector<LevelCounts> count_cube(int cells, VolumeTreatment volume) {
  return cells <= most_made(volume) ? count_levels(make_levels(cells, volume, 2))
                                    : count_cube(cells, volume, count_small_cubes(volume));
}

std::vector<LevelCounts> count_mesh(const std::vector<fem::MeshLevel>& levels, Options& options) {
  std::vector<fem::LevelGraph> graphs = fem::make_counted_graphs(levels);
  std::vector<LevelCounts> counts = count_levels(levels, graphs);
  require_mesh_fits(counts);
  const bool are_wanted = !options.dry_run && options.scene != SceneKind::explicit_dynamics &&
                          options.solver.newton.product == fem::Product::assembled;
  if (are_wanted) options.solver.graphs = std::make_shared<std::vector<fem::LevelGraph>>(std::move(graphs));
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

void require_mesh_fits(const std::vector<LevelCounts>& levels) {
  constexpr std::int64_t most = std::numeric_limits<fem::Index>::max();
  const std::int64_t largest = largest_number(levels);
  if (largest <= most) return;
  throw Error("this mesh: the solver's lists would need numbers up to " + std::to_string(largest) +
              ", and 32-bit numbers only reach " + std::to_string(most) +
              "; take a coarser mesh, or --volume tets, which has the shortest lists");
}

void require_cube_fits(int cells, VolumeTreatment volume) {
  constexpr std::int64_t most = std::numeric_limits<fem::Index>::max();
  if (cells <= most_made(volume)) return;
  const SmallCubes small = count_small_cubes(volume);
  const std::int64_t largest = largest_number(count_cube(cells, volume, small));
  if (largest <= most) return;
  int fitting = cells;
  while (largest_number(count_cube(fitting, volume, small)) > most) {
    fitting -= fitting > 1000 ? fitting / 2 : (fitting % 2 == 0 ? 2 : 1);  // even numbers, which have coarser meshes
  }
  throw Error("--cells " + std::to_string(cells) + ": the solver's lists would need numbers up to " +
              std::to_string(largest) + ", and 32-bit numbers only reach " + std::to_string(most) + "; take --cells " +
              std::to_string(fitting));
}

}  // namespace physgen::truthcube
