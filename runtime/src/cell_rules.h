// What cell lists of all spaces have in common: which cells a box is cut into, and what is refused.
#pragma once

#include <physgen/detail/cell_search.h>
#include <physgen/error.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "cell_grid.h"

namespace physgen::detail::cells {

constexpr index_t most_objects = std::numeric_limits<std::int32_t>::max();

template <class Real>
std::string text(Real number) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr};
}
template <class Real, std::size_t kDimensions>
std::string text(const std::array<Real, kDimensions>& point) {
  std::string all;
  for (const Real x : point) all += (all.empty() ? "(" : ", ") + text(x);
  return all + ")";
}

[[noreturn]] inline void refuse(const std::string& why) { throw Error("CellList: " + why); }

/// @throw Error when the box or the reach cannot be had
template <class Real, int kDimensions>
void check(const CellBox<Real, kDimensions>& box, Real reach) {
  constexpr std::string_view axes = "xyz";
  if (!(reach > 0) || !std::isfinite(reach)) refuse("the reach is " + text(reach) + "; give a positive number");
  if (!std::isnormal(reach * reach)) {
    refuse("the reach is " + text(reach) + ", whose square, " + text(reach * reach) +
           ", cannot be compared with; choose a unit of length in which it is nearer to 1");
  }
  for (std::size_t k = 0; k < kDimensions; ++k) {
    const Real length = box.upper[k] - box.lower[k];
    const std::string ends =
        "the box goes from " + text(box.lower[k]) + " to " + text(box.upper[k]) + " along " + axes[k];
    if (!(length > 0) || !std::isfinite(length)) {
      refuse(ends + "; give finite ends, the lower one less than the upper one");
    }
    if (box.periodic[k] && length < 2 * reach) {
      refuse(ends + " and is periodic, which is less than twice the reach of " + text(reach) +
             ", so that an object could be a neighbour of another twice; give a longer box, in which the objects are "
             "repeated, or a shorter reach");
    }
  }
}

/// @throw Error when there cannot be as many objects
inline void check_size(index_t size) {
  if (size >= 0 && size <= most_objects) return;
  refuse("there cannot be " + std::to_string(size) + " objects; give a number from 0 to " +
         std::to_string(most_objects));
}

[[noreturn]] void refuse_outside(const auto& box, index_t object, const auto& x) {
  const std::string at = "object " + std::to_string(object) + " is at " + text(x);
  if (!std::ranges::all_of(x, [](auto along) { return std::isfinite(along); })) {
    refuse(at + ", which is nowhere; look at what computed its position, such as a time step that is too long");
  }
  const bool periodic = std::ranges::any_of(box.periodic, [](bool each) { return each; });
  refuse(at + ", outside the box from " + text(box.lower) + " to " + text(box.upper) +
         (periodic ? "; move it by whole lengths of the box where that is periodic, and elsewhere"
                   : "; give a box with room for all objects, or") +
         " keep objects in it");
}

[[noreturn]] void refuse_neighbours(index_t objects, index_t limit, auto reach) {
  refuse(std::to_string(objects) + " objects have more than " + std::to_string(limit) +
         " neighbours within a reach of " + text(reach) +
         "; give a shorter reach, or look at whether the objects have fallen together");
}
/// How many neighbours there may be, of those that are wanted at most.
[[nodiscard]] inline index_t limit(index_t most) { return std::clamp<index_t>(most, 0, most_objects); }

/// More than what rounding makes of positions in a box, of distances in it, and of cells' numbers.
template <class Real, int kDimensions>
double rounding_of(const CellBox<Real, kDimensions>& box, Real reach) {
  double most = static_cast<double>(reach);
  for (std::size_t k = 0; k < kDimensions; ++k) {
    const auto lower = static_cast<double>(box.lower[k]), upper = static_cast<double>(box.upper[k]);
    most = std::max({most, std::abs(lower), std::abs(upper), upper - lower});
  }
  return 16 * static_cast<double>(std::numeric_limits<Real>::epsilon()) * most;
}

/// No list of so many objects has more cells.
[[nodiscard]] constexpr index_t most_cells(index_t size) { return std::min(2 * size + 4096, most_objects - 1); }

/// Cells as narrow as the reach allows, but not many more than there are objects.
template <class Real, int kDimensions>
[[nodiscard]] CellGrid<Real, kDimensions> grid_for(const CellBox<Real, kDimensions>& box, Real reach, index_t size) {
  const double width = static_cast<double>(reach) + rounding_of(box, reach), most_along = 1 << 20;
  CellGrid<Real, kDimensions> grid;
  grid.lower = box.lower;
  grid.upper = box.upper;
  grid.counts = {1, 1, 1};
  grid.square = reach * reach;
  std::array<double, kDimensions> length;
  for (std::size_t k = 0; k < kDimensions; ++k) {
    length[k] = static_cast<double>(box.upper[k]) - static_cast<double>(box.lower[k]);
    grid.counts[k] = static_cast<std::int32_t>(std::clamp(std::floor(length[k] / width), 1.0, most_along));
    grid.length[k] = box.periodic[k] ? box.upper[k] - box.lower[k] : 0;
    grid.half[k] = box.periodic[k] ? grid.length[k] / 2 : std::numeric_limits<Real>::infinity();
  }
  auto& counts = grid.counts;
  while (index_t{counts[0]} * counts[1] * counts[2] > most_cells(size)) {
    std::int32_t& longest = *std::ranges::max_element(counts);
    longest = (longest + 1) / 2;
  }
  for (std::size_t k = 0; k < kDimensions; ++k) grid.cells_per_length[k] = counts[k] / length[k];
  return grid;
}

}  // namespace physgen::detail::cells
