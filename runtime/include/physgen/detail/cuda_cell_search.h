// The work of a cell list in CUDA memory, compiled once in the library.
#pragma once

#include <physgen/arrays/untyped_array.h>
#include <physgen/detail/cell_search.h>
#include <physgen/memory/buffer.h>

namespace physgen::detail {

/// See CellList. All calls work on the current device.
template <class Real, int kDimensions>
class CudaCellSearch {
 public:
  CudaCellSearch(const CellBox<Real, kDimensions>& box, Real reach);

  [[nodiscard]] const CellBox<Real, kDimensions>& box() const { return box_; }
  [[nodiscard]] Real reach() const { return reach_; }
  [[nodiscard]] index_t size() const { return size_; }
  [[nodiscard]] std::array<index_t, kDimensions> cells() const;
  /// Waits for the stream of build().
  [[nodiscard]] HostList<index_t> order() const;

 protected:
  /// Room for the positions of `size` objects, those of each one behind the other. @throw Error when there cannot be as
  /// many
  Real* begin(index_t size);
  /// Sorts the objects whose positions are written in `stream` by cell. Waits for whether one lies outside.
  /// @throw Error when one lies outside the box
  void sort(Stream stream);
  /// Counts the neighbours of all. Waits for the number of all. @throw Error when there are too many
  index_t search(bool with_itself, index_t most, Stream stream);
  /// Writes what search() has found. @pre the arrays have room for it
  void write_rows(const UntypedArray& ranges, const UntypedArray& entries, Stream stream) const;

 private:
  struct Given;
  struct Sorted;
  [[nodiscard]] Given given() const;
  [[nodiscard]] Sorted sorted() const;

  CellBox<Real, kDimensions> box_;
  Real reach_;
  index_t size_ = 0;                             ///< of what is sorted
  std::array<std::int32_t, 3> counts_{1, 1, 1};  ///< of cells along each axis, 1 along those that a box does not have
  Stream stream_ = nullptr;                      ///< that sorts
  bool with_itself_ = false;                     ///< as of search()
  index_t given_size_ = 0;                       ///< of the objects whose positions are given
  index_t given_room_ = 0, sorted_room_ = 0;     ///< objects for which there is memory
  Buffer given_;                                 ///< positions, and memory for the time of a call
  Buffer sorted_;                                ///< objects by cell
};

}  // namespace physgen::detail
