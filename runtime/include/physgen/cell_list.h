// Objects within reach of each other: a box is cut into cells no narrower than the reach, so that the neighbours of an
// object lie in its own cell and those around it.
#pragma once

#include <physgen/detail/cell_search.h>
#include <physgen/detail/host_loop.h>
#include <physgen/detail/row_fill.h>
#include <physgen/memory/host_list.h>
#include <physgen/row_arrays.h>

#include <array>
#include <limits>
#include <type_traits>
#include <utility>

namespace physgen {

/// Whether an object is a neighbour of itself.
enum class OwnEntry { left_out, included };

namespace detail {

/// A coordinate of a position, as a list of Real takes it.
template <class Real, class Element>
[[nodiscard]] PHYSGEN_FUNCTION Real coordinate(Element&& x) {
  static_assert(!std::is_same_v<std::remove_cvref_t<Element>, double> || std::is_same_v<Real, double>,
                "positions in double lose digits in a CellList<float>: take a CellList<double>");
  return static_cast<Real>(std::forward<Element>(x));
}

}  // namespace detail

/// Finds the neighbours of objects, such as particles, on threads(), with the same entries in the same order on any
/// number of them:
///
///     CellList<float> cells({.lower = {0, 0, 0}, .upper = {1, 1, 2}}, reach);
///     cells.build(Host{}, particles.size(), [view = particles.const_view()](index_t i) { return view[i].x().get(); });
///     cells.find_neighbours(neighbours);  // RowArrays
///
/// Objects i and j are neighbours where dx dx + (dy dy + dz dz), computed in Real without fused operations, is less
/// than reach times reach; in two dimensions it is dx dx + dy dy. dx is x[i] - x[j]; where the box is periodic, minus
/// its length if that exceeds half of it, or plus its length if it is less than minus half of it. No pair is missed by
/// rounding.
///
/// Lists keep their memory, so that a list that is built and searched again does not ask for more until there are more
/// objects or neighbours than before.
/// @tparam Real float or double, of positions
/// @tparam Space Host; on a CUDA device see <physgen/cuda/cell_list.h>
template <class Real, int kDimensions = 3, class Space = Host>
class CellList : detail::CellSearch<Real, kDimensions> {
  using Search = detail::CellSearch<Real, kDimensions>;

  static_assert(std::is_same_v<Space, Host>,
                "a CellList in Cuda memory is that of <physgen/cuda/cell_list.h>, which .cu files include");

 public:
  using Box = CellBox<Real, kDimensions>;

  /// @throw Error when the box has no width or an end that is not finite; when the reach is not positive, or its square
  /// has no number; or when a periodic box is shorter than twice the reach, so that one object could be a neighbour
  /// twice
  CellList(const Box& box, Real reach) : Search(box, reach) {}

  using Search::box;
  /// Cells along each axis, as of build(): each at least as wide as the reach, and in all not many more than objects.
  using Search::cells;
  using Search::reach;
  /// Objects, as of build().
  using Search::size;
  /// The objects' numbers by cell, those along the first axis one behind the other, and in a cell ascending.
  /// `permute(particles, cells.order())` lets neighbours lie together; the list is then one of the old numbers, so
  /// build it anew.
  using Search::order;

  /// Puts the objects 0 .. size-1 into cells.
  /// @param position called once for each object, in any order; gives what has the elements [0] .. [kDimensions - 1]
  /// @throw Error naming the first object that lies outside the box or nowhere, with its position, or when there are
  /// more than 2^31 - 1; the list is as it was. A periodic box has its upper end, too. @throw what a call throws
  template <class Position>
  void build(Host /*space*/, index_t size, const Position& position) {
    auto& points = this->begin(size);
    detail::host_loop(size, [&](index_t i) {
      auto&& x = position(i);
      for (int k = 0; k < kDimensions; ++k) {
        points[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] =
            detail::coordinate<Real>(std::forward<decltype(x)>(x)[k]);
      }
    });
    this->sort();
  }

  /// Row i gets the neighbours of object i, in the order of order(): ascending by cell, and in a cell by number. The
  /// rows are made in the memory that `rows` has, where it suffices; all views of `rows` end.
  /// @param rows in memory of the host; the one field of its entries is an Index
  /// @param most neighbours in all. @throw Error when there are more; the rows are as they were
  template <class Ranges, class Entries>
  void find_neighbours(RowArrays<Ranges, Entries>& rows, OwnEntry own = OwnEntry::left_out,
                       index_t most = std::numeric_limits<std::int32_t>::max()) {
    this->search(own == OwnEntry::included, most);
    detail::RowFill::make_room<Host>(rows, size(), this->first_.back());
    detail::RowFill::fill(rows, this->first_, [&](auto entries) {
      detail::for_each_index<detail::neighbours_of_a_block>(0, this->blocks(), [&](index_t b) {
        this->for_each_row(b, [&](index_t k, std::int32_t number) { entries.put(k, {number}); });
      });
    });
  }
};

}  // namespace physgen
