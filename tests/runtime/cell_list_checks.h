// What tests of cell lists on the host and on a device share: points of hard cases, and rows as lists.
#pragma once

#include <physgen/cell_list.h>
#include <physgen/random.h>
#include <quasistatic.physgen.h>

#include <algorithm>
#include <cmath>

#include "test_objects.h"

namespace physgen::test {

using Neighbours = RowArrays<elasticity::IncidenceRangeArray<float>, quasistatic::TetPatchArray<float>>;
using Lists = std::vector<std::vector<std::int32_t>>;
template <class Real, int kDimensions>
using Points = std::vector<std::array<Real, kDimensions>>;

inline Lists lists_of(const Neighbours& rows) {
  Lists lists;
  for (index_t i = 0; i < rows.size(); ++i) {
    const auto range = rows.ranges().view().get(i);
    std::vector<std::int32_t>& list = lists.emplace_back();
    for (index_t k = range.begin; k < range.end; ++k) list.push_back(rows.entries().view().get(k).patch);
  }
  return lists;
}

/// Random points of a box: anywhere, in a few clusters, and on faces of cells and of the box, one next to it, too.
template <class Real, int kDimensions>
Points<Real, kDimensions> random_points(index_t size, const CellBox<Real, kDimensions>& box, Real reach,
                                        std::uint32_t use) {
  Points<Real, kDimensions> points;
  for (index_t i = 0; i < size; ++i) {
    RandomNumbers numbers(seed(), i, use);
    auto& point = points.emplace_back();
    const auto kind = numbers.bits() % 4;
    for (std::size_t k = 0; k < kDimensions; ++k) {
      const Real lower = box.lower[k], upper = box.upper[k], length = upper - lower;
      Real x = lower + length * numbers.uniform<Real>();
      if (kind == 1) x = lower + length / 3 + reach / 8 * numbers.uniform<Real>();
      if (kind == 2) {
        x = lower + reach * std::floor(length / reach * numbers.uniform<Real>());
        if (numbers.bits() % 3 == 0) x = std::nextafter(x, numbers.bits() % 2 == 0 ? lower : upper);
      }
      if (kind == 3 && numbers.bits() % 2 == 0) x = numbers.bits() % 2 == 0 ? lower : upper;
      point[k] = std::clamp(x, lower, upper);
    }
  }
  return points;
}

/// Calls check(box, reach) for boxes of all sorts, with cells in a row, in a plane and one alone.
template <class Real, int kDimensions, class Check>
void for_boxes(const Check& check) {
  const Real lower[]{Real(-1.25), 0, Real(100)}, length[]{Real(4), Real(2.5), Real(3.7)};
  for (int periodic = 0; periodic < 1 << kDimensions; ++periodic) {
    CellBox<Real, kDimensions> box;
    for (std::size_t k = 0; k < kDimensions; ++k) {
      box.lower[k] = lower[k];
      box.upper[k] = lower[k] + length[k];
      box.periodic[k] = (periodic >> k & 1) != 0;
    }
    // Twice 1.25 is the length of the second axis: two cells, or one, where it is periodic.
    for (const Real reach : {Real(0.25), Real(0.7), Real(1), Real(1.25)}) {
      SCOPED_TRACE("periodic " + std::to_string(periodic) + ", reach " + std::to_string(reach));
      check(box, reach);
    }
  }
}

}  // namespace physgen::test
