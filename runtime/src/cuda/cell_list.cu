// Cell lists in CUDA memory: a thread takes one object.
#include <physgen/cuda/check.h>
#include <physgen/cuda/parallel_for.h>
#include <physgen/detail/cuda_cell_search.h>
#include <physgen/device.h>

#include "../cell_rules.h"
#include "../index_field.h"
#include "../move_objects.h"
#include "parts/cub_lists.h"

namespace physgen::detail {

namespace {

/// The cell of each object, its number behind it, and the first one that lies in none.
template <class Real, int kDimensions>
struct FindCells {
  CellGrid<Real, kDimensions> grid;
  const Real* points;
  std::uint32_t *cells, *numbers;
  unsigned long long* outside;

  __device__ void operator()(index_t i) const {
    const std::int32_t cell = grid.cell_of(points + i * kDimensions);
    cells[i] = static_cast<std::uint32_t>(cell);
    numbers[i] = static_cast<std::uint32_t>(i);
    if (cell < 0) atomicMin(outside, static_cast<unsigned long long>(i));
  }
};

/// Coordinates of the objects in the order of their cells.
template <class Real, int kDimensions>
struct PlaceObjects {
  const std::uint32_t *sorted_cells, *sorted_numbers;
  const Real* points;
  std::int32_t *cells, *members;
  std::array<Real*, kDimensions> places;

  __device__ void operator()(index_t place) const {
    const std::uint32_t number = sorted_numbers[place];
    cells[place] = static_cast<std::int32_t>(sorted_cells[place]);
    members[place] = static_cast<std::int32_t>(number);
    for (std::size_t k = 0; k < kDimensions; ++k) places[k][place] = points[index_t{number} * kDimensions + k];
  }
};

/// The first place of a cell: that of the first object whose cell is not before it.
struct BeginCells {
  const std::int32_t* cells;
  index_t size;
  std::int32_t* begin;

  __device__ void operator()(index_t cell) const {
    index_t first = 0, last = size;
    while (first < last) {
      const index_t middle = first + (last - first) / 2;
      if (cells[middle] < cell) {
        first = middle + 1;
      } else {
        last = middle;
      }
    }
    begin[cell] = static_cast<std::int32_t>(first);
  }
};

template <class Real, int kDimensions>
struct CountNear {
  PlacedObjects<Real, kDimensions> objects;
  bool with_itself;
  std::int32_t* counts;

  __device__ void operator()(index_t place) const {
    std::int32_t count = 0;
    objects.for_each_near(place, with_itself, [&](std::int32_t) { ++count; });
    counts[objects.members[place]] = count;
  }
};

template <class Real, int kDimensions>
struct WriteNear {
  PlacedObjects<Real, kDimensions> objects;
  bool with_itself;
  const std::int32_t* first;
  Indices begin, end, entries;

  __device__ void operator()(index_t place) const {
    const std::int32_t row = objects.members[place];
    index_t next = first[row];
    begin(row, 0) = first[row];
    end(row, 0) = first[row + 1];
    objects.for_each_near(place, with_itself, [&](std::int32_t number) { entries(next++, 0) = number; });
  }
};

template <class T>
void download(T* to, const T* from, index_t count, Stream stream) {
  const auto bytes = static_cast<std::size_t>(count) * sizeof(T);
  cuda::check(cudaMemcpyAsync(to, from, bytes, cudaMemcpyDeviceToHost, stream), "reading a cell list");
  synchronize(stream);
}

/// Gets memory for lists of `size` objects, unless there is; what it held is gone. @param take as Given and Sorted do
template <class Lists>
void make_room(Buffer& memory, index_t& room, index_t size) {
  if (size <= room) return;
  const index_t wanted = std::min(size + size / 8, cells::most_objects);
  Buffer larger(SpaceKind::cuda, Lists(nullptr, wanted).bytes, "a CellList of " + std::to_string(size) + " objects");
  memory.swap(larger);
  room = wanted;
}

}  // namespace

/// Lists in given_, of `room` objects.
template <class Real, int kDimensions>
struct CudaCellSearch<Real, kDimensions>::Given {
  Real* points;
  cuda::Pairs<std::uint32_t> pairs;
  unsigned long long* outside;
  cuda::Workspace workspace;
  index_t bytes;

  Given(std::byte* memory, index_t room) {
    cuda::Lists lists(memory);
    points = lists.take<Real>(room * kDimensions);
    pairs = {lists.take<std::uint32_t>(room), lists.take<std::uint32_t>(room), lists.take<std::uint32_t>(room),
             lists.take<std::uint32_t>(room), 0};
    outside = lists.take<unsigned long long>(1);
    const NumberList counts(std::span(static_cast<std::int32_t*>(nullptr), static_cast<std::size_t>(room) + 1));
    const index_t most = std::max(cuda::workspace_of_sort<std::uint32_t>(room), cuda::workspace_of_scan(counts));
    workspace = {lists.take<std::byte>(most), most};
    bytes = lists.used();
  }
};

/// Lists in sorted_, of `room` objects.
template <class Real, int kDimensions>
struct CudaCellSearch<Real, kDimensions>::Sorted {
  std::int32_t *cells, *members, *begin_of_cell, *first;
  std::array<Real*, kDimensions> places;
  index_t bytes;

  Sorted(std::byte* memory, index_t room) {
    cuda::Lists lists(memory);
    cells = lists.take<std::int32_t>(room);
    members = lists.take<std::int32_t>(room);
    begin_of_cell = lists.take<std::int32_t>(cells::most_cells(room) + 1);
    first = lists.take<std::int32_t>(room + 1);
    for (auto& along : places) along = lists.take<Real>(room);
    bytes = lists.used();
  }
  [[nodiscard]] PlacedObjects<Real, kDimensions> objects(const CellGrid<Real, kDimensions>& grid) const {
    PlacedObjects<Real, kDimensions> result{grid, begin_of_cell, members, cells, {}};
    std::copy(places.begin(), places.end(), result.places.begin());
    return result;
  }
};

template <class Real, int kDimensions>
auto CudaCellSearch<Real, kDimensions>::given() const -> Given {
  return {given_.data(), given_room_};
}
template <class Real, int kDimensions>
auto CudaCellSearch<Real, kDimensions>::sorted() const -> Sorted {
  return {sorted_.data(), sorted_room_};
}

template <class Real, int kDimensions>
CudaCellSearch<Real, kDimensions>::CudaCellSearch(const CellBox<Real, kDimensions>& box, Real reach)
    : box_(box), reach_(reach) {
  cells::check(box, reach);
}

template <class Real, int kDimensions>
std::array<index_t, kDimensions> CudaCellSearch<Real, kDimensions>::cells() const {
  std::array<index_t, kDimensions> result;
  std::copy_n(counts_.begin(), kDimensions, result.begin());
  return result;
}

template <class Real, int kDimensions>
HostList<index_t> CudaCellSearch<Real, kDimensions>::order() const {
  HostList<std::int32_t> members(static_cast<std::size_t>(size_));
  if (size_ > 0) download(members.data(), sorted().members, size_, stream_);
  return {members.begin(), members.end()};
}

template <class Real, int kDimensions>
Real* CudaCellSearch<Real, kDimensions>::begin(index_t size) {
  cells::check_size(size);
  make_room<Given>(given_, given_room_, size);
  given_size_ = size;
  return given().points;
}

template <class Real, int kDimensions>
void CudaCellSearch<Real, kDimensions>::sort(Stream stream) {
  const index_t size = given_size_;
  const CellGrid<Real, kDimensions> grid = cells::grid_for(box_, reach_, size);
  if (size > 0) {
    Given lists = given();
    auto outside = static_cast<unsigned long long>(size);
    cuda::check(cudaMemcpyAsync(lists.outside, &outside, sizeof outside, cudaMemcpyHostToDevice, stream),
                "preparing a cell list");
    parallel_for(Cuda{}, size,
                 FindCells<Real, kDimensions>{grid, lists.points, lists.pairs.keys, lists.pairs.values, lists.outside},
                 stream);
    download(&outside, lists.outside, 1, stream);
    if (const auto object = static_cast<index_t>(outside); object < size) {
      std::array<Real, kDimensions> x;
      download(x.data(), lists.points + object * kDimensions, kDimensions, stream);
      cells::refuse_outside(box_, object, x);
    }
    make_room<Sorted>(sorted_, sorted_room_, size);
    size_ = 0;  // while CUDA may fail
    int bits = 1;
    while (grid.cells() >> bits != 0) ++bits;
    lists.pairs.size = size;
    cuda::sort(lists.pairs, bits, lists.workspace, stream);
    const Sorted to = sorted();
    parallel_for(Cuda{}, size,
                 PlaceObjects<Real, kDimensions>{lists.pairs.keys, lists.pairs.values, lists.points, to.cells,
                                                 to.members, to.places},
                 stream);
    parallel_for(Cuda{}, grid.cells() + 1, BeginCells{to.cells, size, to.begin_of_cell}, stream);
  }
  size_ = size;
  counts_ = grid.counts;
  stream_ = stream;
}

template <class Real, int kDimensions>
index_t CudaCellSearch<Real, kDimensions>::search(bool with_itself, index_t most, Stream stream) {
  if (size_ == 0) return 0;
  const Sorted lists = sorted();
  const auto objects = lists.objects(cells::grid_for(box_, reach_, size_));
  parallel_for(Cuda{}, size_, CountNear<Real, kDimensions>{objects, with_itself, lists.first}, stream);
  cuda::check(cudaMemsetAsync(lists.first + size_, 0, sizeof(std::int32_t), stream), "counting neighbours");
  const NumberList counts(std::span(lists.first, static_cast<std::size_t>(size_) + 1));
  const cuda::Workspace workspace = given().workspace;
  const index_t total = cuda::sum(counts, workspace, stream);
  if (total > cells::limit(most)) cells::refuse_neighbours(size_, cells::limit(most), reach_);
  cuda::scan(counts, workspace, stream);
  with_itself_ = with_itself;
  return total;
}

template <class Real, int kDimensions>
void CudaCellSearch<Real, kDimensions>::write_rows(const UntypedArray& ranges, const UntypedArray& entries,
                                                   Stream stream) const {
  if (size_ == 0) return;
  const Sorted lists = sorted();
  parallel_for(Cuda{}, size_,
               WriteNear<Real, kDimensions>{lists.objects(cells::grid_for(box_, reach_, size_)), with_itself_,
                                            lists.first, Indices(ranges, find_index_field(ranges, "begin")),
                                            Indices(ranges, find_index_field(ranges, "end")),
                                            Indices(entries, entries.fields[0])},
               stream);
}

template class CudaCellSearch<float, 1>;
template class CudaCellSearch<float, 2>;
template class CudaCellSearch<float, 3>;
template class CudaCellSearch<double, 1>;
template class CudaCellSearch<double, 2>;
template class CudaCellSearch<double, 3>;

}  // namespace physgen::detail
