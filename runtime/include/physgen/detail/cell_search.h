// The work of a cell list over plain lists, compiled once in the library.
#pragma once

#include <physgen/config.h>
#include <physgen/memory/host_list.h>

#include <array>
#include <cstdint>
#include <vector>

namespace physgen {

/// Where the objects of a cell list lie: lower <= x <= upper along each axis, and the box follows itself along those
/// that are periodic.
template <class Real, int kDimensions = 3>
struct CellBox {
  std::array<Real, kDimensions> lower{}, upper{};
  std::array<bool, kDimensions> periodic{};
};

namespace detail {

template <class Real, int kDimensions>
struct CellGrid;  // cell_grid.h, of the library

constexpr int neighbours_of_a_block = 512 * 32;  ///< or so, for the guess at what one takes

/// See CellList. What a step makes is valid until it is made again.
template <class Real, int kDimensions>
class CellSearch {
 public:
  using Point = std::array<Real, kDimensions>;

  CellSearch(const CellBox<Real, kDimensions>& box, Real reach);

  [[nodiscard]] const CellBox<Real, kDimensions>& box() const { return box_; }
  [[nodiscard]] Real reach() const { return reach_; }
  [[nodiscard]] index_t size() const { return static_cast<index_t>(members_.size()); }
  [[nodiscard]] std::array<index_t, kDimensions> cells() const;
  [[nodiscard]] HostList<index_t> order() const;

 protected:
  /// Room for the positions of `size` objects. @throw Error when there cannot be as many
  HostList<Point>& begin(index_t size);
  /// Sorts the objects whose positions were written by cell. @throw Error when one lies outside the box
  void sort();
  /// Finds the neighbours of all, block by block, and where rows begin: first_. @throw Error when there are too many
  void search(bool with_itself, index_t most);

  [[nodiscard]] index_t blocks() const { return static_cast<index_t>(blocks_.size()); }
  /// Calls write(k, number) for each entry k of the rows of block b.
  template <class Write>
  void for_each_row(index_t b, const Write& write) const {
    const Block& block = blocks_[static_cast<std::size_t>(b)];
    const std::int32_t* found = block.found.data();
    for (std::int32_t place = block.begin; place < block.end; ++place) {
      const auto row = static_cast<std::size_t>(members_[static_cast<std::size_t>(place)]);
      for (index_t k = first_[row]; k < first_[row + 1]; ++k) write(k, *found++);
    }
  }

  HostList<std::int32_t> first_;  ///< of each object's neighbours, and the number of all

 private:
  using Grid = CellGrid<Real, kDimensions>;
  /// The neighbours of objects in consecutive cells.
  struct Block {
    std::int32_t begin, end;  ///< places in members_
    index_t used = 0;         ///< of `found`, which has room for more
    HostList<std::int32_t> found;
  };
  struct Candidates;

  void gather(const Grid& grid, std::int32_t cell, Candidates& candidates) const;
  void search_block(const Grid& grid, index_t b, bool with_itself, index_t most, Candidates& candidates);

  CellBox<Real, kDimensions> box_;
  Real reach_;
  /// Cells along each axis, 1 along those that a box does not have.
  std::array<std::int32_t, 3> counts_{1, 1, 1};
  HostList<Point> points_;                          ///< of each object
  HostList<std::int32_t> cell_;                     ///< of each object
  HostList<std::int32_t> begin_of_cell_{0, 0};      ///< in members_
  HostList<std::int32_t> members_;                  ///< the objects by cell
  std::array<HostList<Real>, kDimensions> places_;  ///< coordinates of members
  std::vector<Block> blocks_;
};

}  // namespace detail
}  // namespace physgen
