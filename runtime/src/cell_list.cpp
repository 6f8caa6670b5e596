// Cell lists on the host: which objects lie in each cell, and which are within reach of each other.
#include <physgen/detail/cell_search.h>
#include <physgen/fill_rows.h>

#include <algorithm>
#include <atomic>

#include "cell_rules.h"
#include "first_where.h"
#include "near.h"

namespace physgen::detail {

namespace {

constexpr index_t objects_of_a_block = 512;

}  // namespace

template <class Real, int kDimensions>
CellSearch<Real, kDimensions>::CellSearch(const CellBox<Real, kDimensions>& box, Real reach)
    : box_(box), reach_(reach) {
  cells::check(box, reach);
}

template <class Real, int kDimensions>
std::array<index_t, kDimensions> CellSearch<Real, kDimensions>::cells() const {
  std::array<index_t, kDimensions> result;
  std::copy_n(counts_.begin(), kDimensions, result.begin());
  return result;
}

template <class Real, int kDimensions>
HostList<index_t> CellSearch<Real, kDimensions>::order() const {
  HostList<index_t> result(members_.size());
  for_each_index(0, size(),
                 [&](index_t p) { result[static_cast<std::size_t>(p)] = members_[static_cast<std::size_t>(p)]; });
  return result;
}

template <class Real, int kDimensions>
auto CellSearch<Real, kDimensions>::begin(index_t size) -> HostList<Point>& {
  cells::check_size(size);
  points_.resize(static_cast<std::size_t>(size));
  return points_;
}

template <class Real, int kDimensions>
void CellSearch<Real, kDimensions>::sort() {
  const auto size = static_cast<index_t>(points_.size());
  const CellGrid<Real, kDimensions> grid = cells::grid_for(box_, reach_, size);
  cell_.resize(points_.size());
  const index_t outside = first_where(size, [&](index_t i) {
    std::int32_t& cell = cell_[static_cast<std::size_t>(i)];
    cell = grid.cell_of(points_[static_cast<std::size_t>(i)].data());
    return cell < 0;
  });
  if (outside < size) cells::refuse_outside(box_, outside, points_[static_cast<std::size_t>(outside)]);
  counts_ = grid.counts;
  fill_rows(
      Host{}, grid.cells(), size,
      [&](index_t i, const auto& put) { put(cell_[static_cast<std::size_t>(i)], static_cast<std::int32_t>(i)); },
      begin_of_cell_, members_);
  for (auto& along : places_) along.resize(points_.size());
  for_each_index(0, size, [&](index_t p) {
    const Point& x = points_[static_cast<std::size_t>(members_[static_cast<std::size_t>(p)])];
    for (std::size_t k = 0; k < kDimensions; ++k) places_[k][static_cast<std::size_t>(p)] = x[k];
  });
}

/// The members of the cells around one, in their order.
template <class Real, int kDimensions>
struct CellSearch<Real, kDimensions>::Candidates {
  std::array<HostList<Real>, kDimensions> places;
  HostList<std::int32_t> numbers;
  index_t size, own;  ///< own: the first one of the cell in the middle
};

template <class Real, int kDimensions>
void CellSearch<Real, kDimensions>::gather(const Grid& grid, std::int32_t cell, Candidates& candidates) const {
  candidates.size = 0;
  grid.for_each_run(cell, [&](std::int32_t first, std::int32_t last) {
    const std::int32_t begin = begin_of_cell_[static_cast<std::size_t>(first)];
    const index_t count = begin_of_cell_[static_cast<std::size_t>(last) + 1] - begin, size = candidates.size;
    if (first <= cell && cell <= last) {
      candidates.own = size + begin_of_cell_[static_cast<std::size_t>(cell)] - begin;
    }
    const auto room = static_cast<std::size_t>(size + count + room_behind);
    if (candidates.numbers.size() < room) {
      candidates.numbers.resize(2 * room);
      for (auto& along : candidates.places) along.resize(2 * room);
    }
    std::copy_n(members_.begin() + begin, count, candidates.numbers.begin() + size);
    for (std::size_t k = 0; k < kDimensions; ++k) {
      std::copy_n(places_[k].begin() + begin, count, candidates.places[k].begin() + size);
    }
    candidates.size += count;
  });
}

template <class Real, int kDimensions>
void CellSearch<Real, kDimensions>::search_block(const Grid& grid, index_t b, bool with_itself, index_t most,
                                                 Candidates& candidates) {
  Block& block = blocks_[static_cast<std::size_t>(b)];
  block.begin = static_cast<std::int32_t>(b * objects_of_a_block);
  block.end = static_cast<std::int32_t>(std::min(size(), (b + 1) * objects_of_a_block));
  block.used = 0;
  Near<Real, kDimensions> near{.places = {}, .numbers = nullptr, .count = 0, .grid = grid};
  std::int32_t cell = -1, begin = 0, end = 0;  // of the cell that `candidates` are of
  for (std::int32_t place = block.begin; place < block.end && block.used <= most; ++place) {
    if (place >= end) {
      const auto next = std::upper_bound(begin_of_cell_.begin() + cell + 1, begin_of_cell_.end(), place);
      cell = static_cast<std::int32_t>(next - begin_of_cell_.begin()) - 1;
      begin = begin_of_cell_[static_cast<std::size_t>(cell)];
      end = *next;
      gather(grid, cell, candidates);
      near.count = candidates.size;
      near.numbers = candidates.numbers.data();
      for (std::size_t k = 0; k < kDimensions; ++k) near.places[k] = candidates.places[k].data();
    }
    const auto room = static_cast<std::size_t>(block.used + candidates.size + room_behind);
    if (block.found.size() < room) block.found.resize(room + room / 2);
    const index_t count =
        append_near(near, candidates.own + (place - begin), with_itself, block.found.data() + block.used);
    first_[static_cast<std::size_t>(members_[static_cast<std::size_t>(place)])] = static_cast<std::int32_t>(count);
    block.used += count;
  }
}

template <class Real, int kDimensions>
void CellSearch<Real, kDimensions>::search(bool with_itself, index_t most) {
  const index_t limit = cells::limit(most);
  const Grid grid = cells::grid_for(box_, reach_, size());
  blocks_.resize(static_cast<std::size_t>((size() + objects_of_a_block - 1) / objects_of_a_block));
  first_.resize(members_.size() + 1);
  first_.back() = 0;
  Spares<Candidates> spares;
  RegionFailure failure;
  std::atomic<index_t> found = 0;
  for_each_index<neighbours_of_a_block>(0, blocks(), [&](index_t b) {
    if (found > limit) return;
    failure.guard([&] {
      spares.lend([] { return Candidates(); },
                  [&](Candidates& candidates) { search_block(grid, b, with_itself, limit, candidates); });
      found += blocks_[static_cast<std::size_t>(b)].used;
    });
  });
  failure.rethrow();
  if (found > limit) cells::refuse_neighbours(size(), limit, reach_);
  exclusive_scan(Host{}, std::span(first_));
}

template class CellSearch<float, 1>;
template class CellSearch<float, 2>;
template class CellSearch<float, 3>;
template class CellSearch<double, 1>;
template class CellSearch<double, 2>;
template class CellSearch<double, 3>;

}  // namespace physgen::detail
