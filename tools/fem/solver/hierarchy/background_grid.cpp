#include <fem/solver/hierarchy/background_grid.h>
#include <fem/solver/hierarchy/grid_axis.h>
#include <physgen/error.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

namespace physgen::fem {

namespace {

using Cells = std::array<Index, 3>;
using Axes = std::array<GridAxis, 3>;

/// The number of a corner of the grid among all of the box, which may have more than 32-bit numbers reach.
using CornerNumber = std::int64_t;

/// A grid's node whose free children all weigh less has the square of that for stiffness, which rounding of the blocks
/// between which it is a difference would spoil. It is left out.
constexpr double least_weight = 1e-3;

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
Located locate_in(const Axes& axes, const Cells& cells, const Point& x) {
  constexpr double rounding = 1e-9;  // of a cell: closer to a face than this is on it
  std::array<Index, 3> at{};
  Point part{};
  for (std::size_t k = 0; k < 3; ++k) std::tie(at[k], part[k]) = axes[k].locate(x[k]);
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

/// Numbers of those corners of a grid that are used.
class UsedCorners {
 public:
  explicit UsedCorners(std::vector<CornerNumber> numbers) : numbers_(std::move(numbers)) {
    std::ranges::sort(numbers_);
    const auto twice = std::ranges::unique(numbers_);
    numbers_.erase(twice.begin(), twice.end());
  }
  [[nodiscard]] const std::vector<CornerNumber>& numbers() const { return numbers_; }
  [[nodiscard]] Index operator[](CornerNumber number) const {
    return static_cast<Index>(std::ranges::lower_bound(numbers_, number) - numbers_.begin());
  }

 private:
  std::vector<CornerNumber> numbers_;
};

/// A level of these corners, all prescribed.
MeshLevel make_level(const Axes& axes, const Cells& cells, const UsedCorners& corners) {
  MeshLevel level;
  level.mesh.nodes = static_cast<Index>(corners.numbers().size());
  for (const CornerNumber number : corners.numbers()) {
    const auto at = corner_at(cells, number);
    Point x{};
    for (std::size_t k = 0; k < 3; ++k) x[k] = axes[k].plane(at[k], cells[k]);
    level.rest.push_back(x);
  }
  level.fixed.assign(level.rest.size(), 7);
  return level;
}

/// The finest grid, and where the nodes of the mesh lie in it.
MeshLevel make_finest(const Axes& axes, const Cells& cells, MeshLevel& mesh, UsedCorners& corners) {
  std::vector<Located> located;
  std::vector<CornerNumber> numbers;
  for (const Point& x : mesh.rest) {
    located.push_back(locate_in(axes, cells, x));
    numbers.insert(numbers.end(), located.back().corners.begin(), located.back().corners.end());
  }
  corners = UsedCorners(std::move(numbers));
  MeshLevel grid = make_level(axes, cells, corners);
  for (std::size_t n = 0; n < located.size(); ++n) {
    GridLocation location{{}, located[n].weights};
    for (std::size_t c = 0; c < 4; ++c) {
      location.nodes[c] = corners[located[n].corners[c]];
      if (location.weights[c] >= least_weight) grid.fixed[static_cast<std::size_t>(location.nodes[c])] &= mesh.fixed[n];
    }
    mesh.grid_parents.push_back(location);
  }
  return grid;
}

/// The next coarser grid: half as many cells where their number is even.
MeshLevel make_coarser(const Axes& axes, Cells& cells, MeshLevel& fine, UsedCorners& corners) {
  Cells coarse = cells;
  for (Index& count : coarse) {
    if (count % 2 == 0) count /= 2;
  }
  std::vector<std::array<CornerNumber, 2>> ends;
  std::vector<CornerNumber> numbers;
  for (const CornerNumber number : corners.numbers()) {
    auto low = corner_at(cells, number), high = low;
    for (std::size_t k = 0; k < 3; ++k) {
      if (coarse[k] == cells[k]) continue;
      high[k] = (low[k] + 1) / 2;
      low[k] /= 2;
    }
    ends.push_back({corner_number(coarse, low), corner_number(coarse, high)});
    numbers.insert(numbers.end(), ends.back().begin(), ends.back().end());
  }
  cells = coarse;
  corners = UsedCorners(std::move(numbers));
  MeshLevel grid = make_level(axes, cells, corners);
  for (std::size_t n = 0; n < ends.size(); ++n) {
    fine.parents.push_back({corners[ends[n][0]], corners[ends[n][1]]});
    for (const Index p : fine.parents.back()) grid.fixed[static_cast<std::size_t>(p)] &= fine.fixed[n];
  }
  return grid;
}

}  // namespace

std::array<Index, 3> add_background_grid(std::vector<MeshLevel>& levels) {
  if (levels.empty() || levels.back().mesh.nodes <= most_coarse_nodes) return {};
  const Box box = box_around(levels.back().rest);
  const Cells finest = choose_cells(box, 2 * mean_spacing(levels.back().mesh, levels.back().rest));
  const auto axis = [&](std::size_t k) {
    GridAxis found(box.low[k], box.high[k], finest[k]);
    found.follow(levels.back().mesh, levels.back().rest, k);
    return found;
  };
  const Axes axes{axis(0), axis(1), axis(2)};
  Cells cells = finest;
  UsedCorners corners({});
  levels.push_back(make_finest(axes, cells, levels.back(), corners));
  const auto even = [](Index count) { return count % 2 == 0; };
  while (levels.back().mesh.nodes > most_coarse_nodes && std::ranges::any_of(cells, even)) {
    levels.push_back(make_coarser(axes, cells, levels.back(), corners));
  }
  return finest;
}

}  // namespace physgen::fem
