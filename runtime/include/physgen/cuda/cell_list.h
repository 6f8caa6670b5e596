// Objects within reach of each other, found on a CUDA device. Included by CUDA translation units only.
#pragma once

#include <physgen/cell_list.h>
#include <physgen/cuda/parallel_for.h>
#include <physgen/detail/cuda_cell_search.h>

namespace physgen {

namespace cuda {

template <class Real, int kDimensions, class Position>
struct StorePosition {
  Position position;
  Real* points;
  __device__ void operator()(index_t i) const {
    auto&& x = position(i);
    for (int k = 0; k < kDimensions; ++k) {
      points[i * kDimensions + k] = detail::coordinate<Real>(std::forward<decltype(x)>(x)[k]);
    }
  }
};

}  // namespace cuda

/// The cell list in CUDA memory: the same cells, the same rows in the same order as on the host, on any device.
///
///     CellList<float, 3, Cuda> cells({.lower = {0, 0, 0}, .upper = {1, 1, 2}}, reach);
///     cells.build(Cuda{}, particles.size(), PositionOf{particles.const_view()});
///     cells.find_neighbours(neighbours);  // RowArrays in Cuda
///
/// Its calls allocate memory only where there are more objects or neighbours than before. It can be moved, not copied.
template <class Real, int kDimensions>
class CellList<Real, kDimensions, Cuda> : detail::CudaCellSearch<Real, kDimensions> {
  using Search = detail::CudaCellSearch<Real, kDimensions>;

 public:
  using Box = CellBox<Real, kDimensions>;

  /// @throw Error as on the host, and in a program that has physgen without CUDA
  CellList(const Box& box, Real reach) : Search(box, reach) {}

  using Search::box;
  using Search::cells;
  using Search::reach;
  using Search::size;
  /// In memory of the host, as permute() takes it; waits.
  using Search::order;

  /// Puts the objects 0 .. size-1 into cells, ordered in `stream`; waits for whether all lie in the box.
  /// @param position a function object whose call operator runs on the device
  /// @throw Error as on the host; the list is as it was, unless CUDA fails
  template <class Position>
  void build(Cuda space, index_t size, const Position& position, Stream stream = nullptr) {
    Real* const points = this->begin(size);
    parallel_for(space, size, cuda::StorePosition<Real, kDimensions, Position>{position, points}, stream);
    this->sort(stream);
  }

  /// As on the host, ordered in `stream`; waits for the number of neighbours, and not for the rows.
  /// @param rows in memory of CUDA. @pre work on them in other streams is done (see synchronize())
  /// @throw Error as on the host; the rows are as they were, unless CUDA fails
  template <class Ranges, class Entries>
  void find_neighbours(RowArrays<Ranges, Entries>& rows, OwnEntry own = OwnEntry::left_out,
                       index_t most = std::numeric_limits<std::int32_t>::max(), Stream stream = nullptr) {
    const index_t count = this->search(own == OwnEntry::included, most, stream);
    detail::RowFill::make_room<Cuda>(rows, size(), count);
    this->write_rows(rows.ranges().untyped(), rows.entries().untyped(), stream);
  }
};

}  // namespace physgen
