// The arithmetic of cell lists, on the host and on the device: which cell a position lies in, which cells are around
// one, and which objects are near. Compile it without fused operations, so that all give the same bits.
#pragma once

#include <physgen/config.h>

#include <array>
#include <cstdint>

namespace physgen::detail {

/// Adds the square of a difference of positions along one axis to `sum`; across a periodic box, of the nearest image.
/// The first axis that is added sets the sum.
/// @tparam Number a Real, or a vector of them
/// @param length of the box, and its half: 0 and infinity where it is not periodic
template <class Number, class Real>
[[gnu::always_inline]] PHYSGEN_FUNCTION inline void add_square(Number& sum, const Number& difference, Real length,
                                                               Real half, bool first) {
  const Number d = difference > half ? difference - length : difference < -half ? difference + length : difference;
  sum = first ? d * d : d * d + sum;
}

/// A box cut into cells. cell_rules.h makes it.
template <class Real, int kDimensions>
struct CellGrid {
  std::array<Real, kDimensions> lower, upper;
  std::array<Real, kDimensions> length, half;  ///< see add_square()
  std::array<double, kDimensions> cells_per_length;
  std::array<std::int32_t, 3> counts;  ///< of cells along each axis, 1 along those that a box does not have
  Real square;                         ///< of the reach

  [[nodiscard]] PHYSGEN_FUNCTION std::int32_t cells() const { return counts[0] * counts[1] * counts[2]; }

  /// The cell of a position, or -1 where it lies outside the box or nowhere.
  [[nodiscard]] PHYSGEN_FUNCTION std::int32_t cell_of(const Real* x) const {
    std::int32_t cell = 0;
    for (std::size_t k = kDimensions; k-- > 0;) {
      if (!(x[k] >= lower[k] && x[k] <= upper[k])) return -1;
      const double from_lower = static_cast<double>(x[k]) - static_cast<double>(lower[k]);
      const auto along = static_cast<std::int32_t>(from_lower * cells_per_length[k]);
      cell = cell * counts[k] + (along < counts[k] ? along : counts[k] - 1);
    }
    return cell;
  }

  /// Calls visit(first, last) for the cells around one and itself, those that follow each other together, ascending.
  template <class Visit>
  PHYSGEN_FUNCTION void for_each_run(std::int32_t cell, const Visit& visit) const {
    std::array<Around, 3> around;
    std::int32_t rest = cell;
    for (std::size_t k = 0; k < 3; ++k) {
      around[k] = around_along(k, rest % counts[k]);
      rest /= counts[k];
    }
    const Around& x = around[0];
    for (std::size_t z = 0; z < around[2].count; ++z) {
      for (std::size_t y = 0; y < around[1].count; ++y) {
        const std::int32_t row = counts[0] * (around[1].cells[y] + counts[1] * around[2].cells[z]);
        for (std::size_t begin = 0, end = 1; begin < x.count; begin = end++) {
          while (end < x.count && x.cells[end] == x.cells[end - 1] + 1) ++end;
          visit(row + x.cells[begin], row + x.cells[end - 1]);
        }
      }
    }
  }

 private:
  /// Cells along one axis, ascending.
  struct Around {
    std::array<std::int32_t, 3> cells;
    std::size_t count;
  };
  [[nodiscard]] PHYSGEN_FUNCTION Around around_along(std::size_t k, std::int32_t middle) const {
    const std::int32_t count = counts[k];
    const bool periodic = k < kDimensions && length[k < kDimensions ? k : 0] > 0;
    Around here{{}, 0};
    for (std::int32_t other = middle - 1; other <= middle + 1; ++other) {
      const std::int32_t wrapped = (other + count) % count;
      if (other != wrapped && !periodic) continue;
      std::size_t place = here.count;
      while (place > 0 && here.cells[place - 1] > wrapped) --place;
      if (place > 0 && here.cells[place - 1] == wrapped) continue;
      for (std::size_t behind = here.count++; behind > place; --behind) here.cells[behind] = here.cells[behind - 1];
      here.cells[place] = wrapped;
    }
    return here;
  }
};

/// Objects by cell, for a search that takes one of them at a time.
template <class Real, int kDimensions>
struct PlacedObjects {
  CellGrid<Real, kDimensions> grid;
  const std::int32_t* begin_of_cell;            ///< in the lists below, and their end
  const std::int32_t* members;                  ///< the objects' numbers
  const std::int32_t* cells;                    ///< of each
  std::array<const Real*, kDimensions> places;  ///< coordinates of each

  /// Calls visit(number) for the neighbours of the object at a place, in their order.
  template <class Visit>
  PHYSGEN_FUNCTION void for_each_near(index_t place, bool with_itself, const Visit& visit) const {
    std::array<Real, kDimensions> x;
    for (std::size_t k = 0; k < kDimensions; ++k) x[k] = places[k][place];
    grid.for_each_run(cells[place], [&](std::int32_t first, std::int32_t last) {
      for (index_t other = begin_of_cell[first]; other < begin_of_cell[last + 1]; ++other) {
        Real sum = 0;
        for (std::size_t k = kDimensions; k-- > 0;) {
          add_square(sum, x[k] - places[k][other], grid.length[k], grid.half[k], k + 1 == kDimensions);
        }
        if (sum < grid.square && (with_itself || other != place)) visit(members[other]);
      }
    });
  }
};

}  // namespace physgen::detail
