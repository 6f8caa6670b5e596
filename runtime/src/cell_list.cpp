// Cells of a box: which ones there are, which objects lie in each, and which objects are within reach of each other.
#include <physgen/detail/cell_search.h>
#include <physgen/error.h>
#include <physgen/fill_rows.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

#include "near.h"

namespace physgen::detail {

namespace {

constexpr index_t objects_of_a_block = 512;
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

[[noreturn]] void refuse(const std::string& why) { throw Error("CellList: " + why); }

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

void lower_to(std::atomic<index_t>& least, index_t number) {
  index_t now = least.load();
  while (number < now && !least.compare_exchange_weak(now, number)) {
  }
}

}  // namespace

template <class Real, int kDimensions>
CellSearch<Real, kDimensions>::CellSearch(const CellBox<Real, kDimensions>& box, Real reach)
    : box_(box), reach_(reach) {
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
  if (size < 0 || size > most_objects) {
    refuse("there cannot be " + std::to_string(size) + " objects; give a number from 0 to " +
           std::to_string(most_objects));
  }
  points_.resize(static_cast<std::size_t>(size));
  return points_;
}

/// Cells as narrow as the reach allows, but not many more than there are objects.
template <class Real, int kDimensions>
auto CellSearch<Real, kDimensions>::counts_for(index_t size) const -> Counts {
  const double width = static_cast<double>(reach_) + rounding_of(box_, reach_), most_along = 1 << 20;
  const index_t most = 2 * size + 4096;
  Counts counts{1, 1, 1};
  for (std::size_t k = 0; k < kDimensions; ++k) {
    const double length = static_cast<double>(box_.upper[k]) - static_cast<double>(box_.lower[k]);
    counts[k] = static_cast<std::int32_t>(std::clamp(std::floor(length / width), 1.0, most_along));
  }
  while (index_t{counts[0]} * counts[1] * counts[2] > most) {
    std::int32_t& longest = *std::ranges::max_element(counts);
    longest = (longest + 1) / 2;
  }
  return counts;
}

template <class Real, int kDimensions>
void CellSearch<Real, kDimensions>::sort() {
  const auto size = static_cast<index_t>(points_.size());
  const Counts counts = counts_for(size);
  std::array<double, kDimensions> lower, cells_per_length;
  for (std::size_t k = 0; k < kDimensions; ++k) {
    lower[k] = static_cast<double>(box_.lower[k]);
    cells_per_length[k] = counts[k] / (static_cast<double>(box_.upper[k]) - lower[k]);
  }
  cell_.resize(points_.size());
  std::atomic<index_t> outside = size;
  for_each_index(0, size, [&](index_t i) {
    const Point& x = points_[static_cast<std::size_t>(i)];
    std::int32_t cell = 0;
    for (std::size_t k = kDimensions; k-- > 0;) {
      if (!(x[k] >= box_.lower[k] && x[k] <= box_.upper[k])) {
        lower_to(outside, i);
        return;
      }
      const auto along = static_cast<std::int32_t>((static_cast<double>(x[k]) - lower[k]) * cells_per_length[k]);
      cell = cell * counts[k] + std::min(along, counts[k] - 1);
    }
    cell_[static_cast<std::size_t>(i)] = cell;
  });
  if (outside < size) {
    const Point& x = points_[static_cast<std::size_t>(outside)];
    const std::string at = "object " + std::to_string(outside) + " is at " + text(x);
    if (!std::ranges::all_of(x, [](Real along) { return std::isfinite(along); })) {
      refuse(at + ", which is nowhere; look at what computed its position, such as a time step that is too long");
    }
    const bool periodic = std::ranges::any_of(box_.periodic, [](bool each) { return each; });
    refuse(at + ", outside the box from " + text(box_.lower) + " to " + text(box_.upper) +
           (periodic ? "; move it by whole lengths of the box where that is periodic, and elsewhere"
                     : "; give a box with room for all objects, or") +
           " keep objects in it");
  }
  counts_ = counts;
  fill_rows(
      Host{}, index_t{counts[0]} * counts[1] * counts[2], size,
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
void CellSearch<Real, kDimensions>::gather(std::int32_t cell, Candidates& candidates) const {
  struct Around {
    std::array<std::int32_t, 3> cells;
    int count = 0;
  };
  std::array<Around, 3> around;
  std::int32_t rest = cell;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int32_t count = counts_[k], middle = rest % count;
    rest /= count;
    const bool periodic = k < kDimensions && box_.periodic[k];
    Around& here = around[k];
    for (std::int32_t other = middle - 1; other <= middle + 1; ++other) {
      const std::int32_t wrapped = (other + count) % count;
      const auto end = here.cells.begin() + here.count;
      if ((other != wrapped && !periodic) || std::find(here.cells.begin(), end, wrapped) != end) continue;
      here.cells[static_cast<std::size_t>(here.count++)] = wrapped;
    }
    std::sort(here.cells.begin(), here.cells.begin() + here.count);
  }
  candidates.size = 0;
  const auto append = [&](std::int32_t first, std::int32_t last) {  // cells one behind the other
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
  };
  for (int z = 0; z < around[2].count; ++z) {
    for (int y = 0; y < around[1].count; ++y) {
      const std::int32_t row = counts_[0] * (around[1].cells[static_cast<std::size_t>(y)] +
                                             counts_[1] * around[2].cells[static_cast<std::size_t>(z)]);
      const std::array<std::int32_t, 3>& x = around[0].cells;
      for (int begin = 0, end = 1; begin < around[0].count; begin = end++) {
        while (end < around[0].count && x[static_cast<std::size_t>(end)] == x[static_cast<std::size_t>(end - 1)] + 1) {
          ++end;
        }
        append(row + x[static_cast<std::size_t>(begin)], row + x[static_cast<std::size_t>(end - 1)]);
      }
    }
  }
}

template <class Real, int kDimensions>
void CellSearch<Real, kDimensions>::search_block(index_t b, bool with_itself, index_t most, Candidates& candidates) {
  Block& block = blocks_[static_cast<std::size_t>(b)];
  block.begin = static_cast<std::int32_t>(b * objects_of_a_block);
  block.end = static_cast<std::int32_t>(std::min(size(), (b + 1) * objects_of_a_block));
  block.used = 0;
  Near<Real, kDimensions> near{};
  near.square = reach_ * reach_;
  for (std::size_t k = 0; k < kDimensions; ++k) near.length[k] = box_.periodic[k] ? box_.upper[k] - box_.lower[k] : 0;
  std::int32_t cell = -1, begin = 0, end = 0;  // of the cell that `candidates` are of
  for (std::int32_t place = block.begin; place < block.end && block.used <= most; ++place) {
    if (place >= end) {
      const auto next = std::upper_bound(begin_of_cell_.begin() + cell + 1, begin_of_cell_.end(), place);
      cell = static_cast<std::int32_t>(next - begin_of_cell_.begin()) - 1;
      begin = begin_of_cell_[static_cast<std::size_t>(cell)];
      end = *next;
      gather(cell, candidates);
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
  const index_t limit = std::clamp<index_t>(most, 0, std::numeric_limits<std::int32_t>::max());
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
                  [&](Candidates& candidates) { search_block(b, with_itself, limit, candidates); });
      found += blocks_[static_cast<std::size_t>(b)].used;
    });
  });
  failure.rethrow();
  if (found > limit) {
    refuse(std::to_string(size()) + " objects have more than " + std::to_string(limit) +
           " neighbours within a reach of " + text(reach_) +
           "; give a shorter reach, or look at whether the objects have fallen together");
  }
  exclusive_scan(Host{}, std::span(first_));
}

template class CellSearch<float, 1>;
template class CellSearch<float, 2>;
template class CellSearch<float, 3>;
template class CellSearch<double, 1>;
template class CellSearch<double, 2>;
template class CellSearch<double, 3>;

}  // namespace physgen::detail
