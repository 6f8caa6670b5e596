#include <fem/mesh/stages.h>
#include <fem/solver/hierarchy/background_grid.h>
#include <physgen/error.h>
#include <physgen/sort.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <span>
#include <string>
#include <utility>

namespace physgen::fem {

namespace {

using Cells = std::array<Index, 3>;

/// The number of a corner of the grid among all of the box, which may have more than 32-bit numbers reach.
using CornerNumber = std::int64_t;

/// A grid's node whose free children all weigh less has the square of that for stiffness, which rounding of the blocks
/// between which it is a difference would spoil. It is left out.
constexpr double least_weight = 1e-3;

template <class Act>
void each(std::size_t count, const Act& act) {
  physgen::detail::for_each_index<16>(0, static_cast<index_t>(count),
                                      [&act](index_t i) { act(static_cast<std::size_t>(i)); });
}

struct Box {
  Point low, high;
};

Box box_around(const std::vector<Point>& points) {
  Box box{points.front(), points.front()};
  for (const Point& x : points) {
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], x[k]);
      box.high[k] = std::max(box.high[k], x[k]);
    }
  }
  return box;
}

/// Cells about `width` wide, which can be halved until their corners are few enough to be solved exactly; in directions
/// in which the box is thin, until there is one.
Cells choose_cells(const Box& box, double width) {
  for (std::size_t k = 0; k < 3; ++k) {
    constexpr double most = 1 << 20;
    if (box.high[k] - box.low[k] <= most * width) continue;
    throw Error(
        "a background grid would have more than " + std::to_string(1 << 20) +
        " cells in one direction: nodes lie too far from each other for the size of tets; remove those that are "
        "in no tet");
  }
  std::array<double, 3> cells{};
  for (std::size_t k = 0; k < 3; ++k) {
    cells[k] = (box.high[k] - box.low[k]) / width;
    if (!(cells[k] > 0)) throw Error("a background grid needs a body that has an extent in all directions");
  }
  int halvings = 0;
  const auto coarsest = [&](std::size_t k) { return std::max(1.0, std::round(std::ldexp(cells[k], -halvings))); };
  while ((coarsest(0) + 1) * (coarsest(1) + 1) * (coarsest(2) + 1) > most_coarse_nodes) ++halvings;
  Cells chosen{};
  for (std::size_t k = 0; k < 3; ++k) {
    const int own = std::clamp(static_cast<int>(std::lround(std::log2(cells[k]))), 0, halvings);
    chosen[k] = static_cast<Index>(std::ldexp(coarsest(k), coarsest(k) > 1 ? halvings : own));
  }
  return chosen;
}

CornerNumber corner_number(const Cells& cells, const std::array<Index, 3>& at) {
  return at[0] + (CornerNumber{cells[0]} + 1) * (at[1] + (CornerNumber{cells[1]} + 1) * at[2]);
}

std::array<Index, 3> corner_at(const Cells& cells, CornerNumber number) {
  const CornerNumber x = CornerNumber{cells[0]} + 1, y = CornerNumber{cells[1]} + 1;
  return {static_cast<Index>(number % x), static_cast<Index>(number / x % y), static_cast<Index>(number / x / y)};
}

/// The corners of the tet in which a point lies, and their weights: from the corner of its cell that is nearest to the
/// box's low end along the axes, the longest way first.
struct Located {
  std::array<CornerNumber, 4> corners;
  std::array<double, 4> weights;
};
Located locate_in(const Box& box, const Cells& cells, const Point& x) {
  constexpr double rounding = 1e-9;  // of a cell: closer to a face than this is on it
  std::array<Index, 3> at{};
  Point part{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double t = (x[k] - box.low[k]) / (box.high[k] - box.low[k]) * cells[k];
    at[k] = std::clamp(static_cast<Index>(t), Index{0}, cells[k] - 1);
    part[k] = t - at[k];
  }
  std::array<std::size_t, 3> order{0, 1, 2};
  std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t k) { return part[k]; });
  Located located{};
  double before = 1;
  std::size_t used = 0;
  for (std::size_t c = 0; c < 4; ++c) {
    const double next = c < 3 ? part[order[c]] : 0;
    if (before - next > rounding) {
      located.corners[used] = corner_number(cells, at);
      located.weights[used++] = before - next;
    }
    before = next;
    if (c < 3) ++at[order[c]];
  }
  double sum = 0;
  for (const double weight : located.weights) sum += weight;
  for (double& weight : located.weights) weight /= sum;
  for (std::size_t c = used; c < 4; ++c) located.corners[c] = located.corners[0];
  return located;
}

/// Those corners of a grid that are used, ascending, and for each use which of them it is.
struct UsedCorners {
  std::vector<CornerNumber> numbers;
  HostList<Index> of_uses;

  UsedCorners() = default;
  explicit UsedCorners(HostList<CornerNumber> uses) : of_uses(uses.size()) {
    HostList<std::uint32_t> order(uses.size());
    each(order.size(), [&](std::size_t k) { order[k] = static_cast<std::uint32_t>(k); });
    sort_by_key(Host{}, std::span(uses), std::span(order));
    for (std::size_t k = 0; k < uses.size(); ++k) {
      if (k == 0 || uses[k] != uses[k - 1]) numbers.push_back(uses[k]);
      of_uses[order[k]] = static_cast<Index>(numbers.size() - 1);
    }
  }
};

/// A level of these corners, all prescribed.
MeshLevel make_level(const Box& box, const Cells& cells, const UsedCorners& corners) {
  MeshLevel level;
  level.mesh.nodes = static_cast<Index>(corners.numbers.size());
  level.rest.resize(corners.numbers.size());
  each(level.rest.size(), [&](std::size_t n) {
    const auto at = corner_at(cells, corners.numbers[n]);
    for (std::size_t k = 0; k < 3; ++k) level.rest[n][k] = std::lerp(box.low[k], box.high[k], double(at[k]) / cells[k]);
  });
  level.fixed.assign(level.rest.size(), 7);
  return level;
}

/// Of a node of a grid, only what is prescribed at a child, too, stays so. Several threads may say so at once.
void keep_prescribed(MeshLevel& grid, Index node, std::uint8_t fixed) {
  std::atomic_ref(grid.fixed[static_cast<std::size_t>(node)]).fetch_and(fixed, std::memory_order_relaxed);
}

/// The finest grid, and where the nodes of the mesh lie in it.
MeshLevel make_finest(const Box& box, const Cells& cells, MeshLevel& mesh, UsedCorners& corners) {
  const std::size_t nodes = mesh.rest.size();
  HostList<CornerNumber> uses(4 * nodes);
  mesh.grid_parents.resize(nodes);
  each(nodes, [&](std::size_t n) {
    const Located located = locate_in(box, cells, mesh.rest[n]);
    for (std::size_t c = 0; c < 4; ++c) uses[4 * n + c] = located.corners[c];
    mesh.grid_parents[n].weights = located.weights;
  });
  corners = UsedCorners(std::move(uses));
  MeshLevel grid = make_level(box, cells, corners);
  each(nodes, [&](std::size_t n) {
    GridLocation& location = mesh.grid_parents[n];
    for (std::size_t c = 0; c < 4; ++c) {
      location.nodes[c] = corners.of_uses[4 * n + c];
      if (location.weights[c] >= least_weight) keep_prescribed(grid, location.nodes[c], mesh.fixed[n]);
    }
  });
  return grid;
}

/// The next coarser grid: half as many cells where their number is even.
MeshLevel make_coarser(const Box& box, Cells& cells, MeshLevel& fine, UsedCorners& corners) {
  Cells coarse = cells;
  for (Index& count : coarse) {
    if (count % 2 == 0) count /= 2;
  }
  const std::size_t nodes = corners.numbers.size();
  HostList<CornerNumber> uses(2 * nodes);
  each(nodes, [&](std::size_t n) {
    auto low = corner_at(cells, corners.numbers[n]), high = low;
    for (std::size_t k = 0; k < 3; ++k) {
      if (coarse[k] == cells[k]) continue;
      high[k] = (low[k] + 1) / 2;
      low[k] /= 2;
    }
    uses[2 * n] = corner_number(coarse, low);
    uses[2 * n + 1] = corner_number(coarse, high);
  });
  cells = coarse;
  corners = UsedCorners(std::move(uses));
  MeshLevel grid = make_level(box, cells, corners);
  fine.parents.resize(nodes);
  each(nodes, [&](std::size_t n) {
    fine.parents[n] = {corners.of_uses[2 * n], corners.of_uses[2 * n + 1]};
    for (const Index p : fine.parents[n]) keep_prescribed(grid, p, fine.fixed[n]);
  });
  return grid;
}

}  // namespace

std::array<Index, 3> add_background_grid(std::vector<MeshLevel>& levels) {
  if (levels.empty() || levels.back().mesh.nodes <= most_coarse_nodes) return {};
  InStage stage("background grid");
  stage.moves(levels.back().mesh.tets, levels.back().rest);
  const Box box = box_around(levels.back().rest);
  const Cells finest = choose_cells(box, 2 * mean_spacing(levels.back().mesh, levels.back().rest));
  Cells cells = finest;
  UsedCorners corners;
  levels.push_back(make_finest(box, cells, levels.back(), corners));
  const auto even = [](Index count) { return count % 2 == 0; };
  while (levels.back().mesh.nodes > most_coarse_nodes && std::ranges::any_of(cells, even)) {
    levels.push_back(make_coarser(box, cells, levels.back(), corners));
  }
  for (const MeshLevel& level : levels) stage.moves(level.grid_parents, level.parents);
  return finest;
}

}  // namespace physgen::fem
