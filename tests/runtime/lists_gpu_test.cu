// Scans, sorts and cell lists on a CUDA device give what the host gives, to the last entry.
#include <physgen/cuda/cell_list.h>
#include <physgen/scan.h>
#include <physgen/sort.h>

#include <numeric>

#include "cell_list_checks.h"
#include "gpu_fixture.h"

namespace physgen::test {
namespace {

class CudaLists : public GpuTest {};
class CudaCellList : public GpuTest {};

/// A list in CUDA memory.
template <class T>
class DeviceList {
 public:
  explicit DeviceList(const std::vector<T>& values)
      : size_(values.size()), memory_(SpaceKind::cuda, bytes(), "a list of a test") {
    copy_memory(memory_.data(), SpaceKind::cuda, reinterpret_cast<const std::byte*>(values.data()), SpaceKind::host,
                bytes());
  }
  [[nodiscard]] std::span<T> span() const { return {reinterpret_cast<T*>(memory_.data()), size_}; }
  [[nodiscard]] std::vector<T> values() const {
    std::vector<T> result(size_);
    copy_memory(reinterpret_cast<std::byte*>(result.data()), SpaceKind::host, memory_.data(), SpaceKind::cuda, bytes());
    return result;
  }

 private:
  [[nodiscard]] index_t bytes() const { return static_cast<index_t>(size_ * sizeof(T)); }
  std::size_t size_;
  Buffer memory_;
};

template <class Number>
void expect_scan(std::mt19937_64& random, std::size_t size, std::uint64_t below) {
  SCOPED_TRACE(size);
  std::vector<Number> numbers(size);
  for (Number& number : numbers) number = static_cast<Number>(random() % below);
  const DeviceList<Number> there(numbers);
  const index_t total = exclusive_scan(Host{}, std::span(numbers));
  EXPECT_EQ(exclusive_scan(Cuda{}, there.span()), total);
  EXPECT_EQ(there.values(), numbers);
}

TEST_F(CudaLists, a_scan_has_the_sums_of_the_host) {
  std::mt19937_64 random(seed());
  for (const std::size_t size : {0UL, 1UL, 2UL, 1000UL, 16385UL, 3000001UL}) {
    expect_scan<std::int32_t>(random, size, 50);
    expect_scan<std::uint32_t>(random, size, 1000);
    expect_scan<std::int64_t>(random, size, std::uint64_t{1} << 40);
  }
  for (const std::size_t size : {0UL, 1UL, 100UL}) {
    expect_scan<std::int8_t>(random, size, 2);
    expect_scan<std::uint8_t>(random, size, 3);
    expect_scan<std::int16_t>(random, size, 300);
    expect_scan<std::uint16_t>(random, size, 600);
  }
}

TEST_F(CudaLists, a_scan_of_more_than_a_billion_numbers_is_one) {
  constexpr index_t part = index_t{1} << 30, size = part + 10;
  const Buffer memory(SpaceKind::cuda, size * index_t{sizeof(std::int32_t)}, "a long list");
  auto* const numbers = reinterpret_cast<std::int32_t*>(memory.data());
  const auto at = [&](index_t i) { return reinterpret_cast<std::byte*>(numbers + i); };
  for (const std::int32_t i : {0, 9}) {
    const std::int32_t number = i + 1;
    copy_memory(at(part - 1 + i), SpaceKind::cuda, reinterpret_cast<const std::byte*>(&number), SpaceKind::host, 4);
  }
  EXPECT_EQ(exclusive_scan(Cuda{}, std::span(numbers, static_cast<std::size_t>(size))), 11);
  std::vector<std::int32_t> found(12);
  copy_memory(reinterpret_cast<std::byte*>(found.data()), SpaceKind::host, at(part - 2), SpaceKind::cuda, 48);
  EXPECT_EQ(found, (std::vector<std::int32_t>{0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 11}));
}

TEST_F(CudaLists, a_scan_whose_sum_has_no_number_is_refused_as_on_the_host_and_changes_nothing) {
  std::vector<std::int32_t> numbers{2147483647, 1, 0};
  const DeviceList<std::int32_t> there(numbers);
  EXPECT_EQ(message_of([&] { exclusive_scan(Cuda{}, there.span()); }),
            message_of([&] { exclusive_scan(Host{}, std::span(numbers)); }));
  EXPECT_EQ(there.values(), numbers);
  std::vector<std::uint8_t> bytes(256, 1);
  const DeviceList<std::uint8_t> bytes_there(bytes);
  EXPECT_EQ(message_of([&] { exclusive_scan(Cuda{}, bytes_there.span()); }),
            message_of([&] { exclusive_scan(Host{}, std::span(bytes)); }));
  EXPECT_EQ(bytes_there.values(), bytes);
}

struct Two {
  std::int32_t a, b;
  bool operator==(const Two&) const = default;
};
struct Odd {
  std::array<std::uint8_t, 5> bytes;
  bool operator==(const Odd&) const = default;
};

template <class Value, class Key>
void expect_values_sorted(const std::vector<Key>& given) {
  std::vector<Key> keys = given;
  std::vector<Value> values(given.size());
  for (std::size_t i = 0; i < values.size(); ++i) std::memcpy(&values[i], &i, std::min(sizeof(Value), sizeof i));
  const DeviceList<Key> keys_there(keys);
  const DeviceList<Value> values_there(values);
  sort_by_key(Cuda{}, keys_there.span(), values_there.span());
  sort_by_key(Host{}, std::span(keys), std::span(values));
  EXPECT_EQ(keys_there.values(), keys);
  EXPECT_TRUE(values_there.values() == values);
}

template <class Key>
void expect_sorts(std::mt19937_64& random) {
  for (const std::uint64_t mask : {0ULL, 0xFFULL, 0xFF00ULL, 0xFFFF0FULL, 0xFFFFFFFFFFFFFFFFULL}) {
    for (const std::size_t size : {0UL, 1UL, 2UL, 1000UL, 120001UL}) {
      SCOPED_TRACE(size);
      std::vector<Key> keys(size);
      for (Key& key : keys) key = static_cast<Key>(random() & mask);
      expect_values_sorted<std::int32_t>(keys);
      expect_values_sorted<float>(keys);
      expect_values_sorted<Two>(keys);
      expect_values_sorted<Odd>(keys);
      expect_values_sorted<std::int64_t>(keys);
    }
  }
}

TEST_F(CudaLists, sorted_keys_and_values_are_those_of_the_host) {
  std::mt19937_64 random(seed());
  expect_sorts<std::int8_t>(random);
  expect_sorts<std::uint16_t>(random);
  expect_sorts<std::int32_t>(random);
  expect_sorts<std::uint32_t>(random);
  expect_sorts<std::int64_t>(random);
  expect_sorts<std::uint64_t>(random);
}

TEST_F(CudaLists, keys_without_a_value_each_are_refused_as_on_the_host) {
  std::vector<int> keys(3), values(2);
  EXPECT_EQ(message_of([&] { sort_by_key(Cuda{}, std::span(keys), std::span(values)); }),
            message_of([&] { sort_by_key(Host{}, std::span(keys), std::span(values)); }));
}

template <class Layout>
using NeighboursThere =
    RowArrays<elasticity::IncidenceRangeArray<float, Cuda, Layout>, quasistatic::TetPatchArray<float, Cuda, Layout>>;

/// Positions in CUDA memory.
template <class Real, int kDimensions>
struct PositionOf {
  const std::array<Real, kDimensions>* points;
  PHYSGEN_FUNCTION std::array<Real, kDimensions> operator()(index_t i) const { return points[i]; }
};
template <class Real, int kDimensions>
void build(CellList<Real, kDimensions, Cuda>& cells, const Points<Real, kDimensions>& points, Stream stream = nullptr) {
  const DeviceList<std::array<Real, kDimensions>> there(points);
  cells.build(Cuda{}, std::ssize(points), PositionOf<Real, kDimensions>{there.span().data()}, stream);
}
template <class Real, int kDimensions>
void build(CellList<Real, kDimensions>& cells, const Points<Real, kDimensions>& points) {
  cells.build(Host{}, std::ssize(points), PositionOf<Real, kDimensions>{points.data()});
}

template <class Layout = Soa, class Real, int kDimensions>
void expect_rows_of_the_host(CellList<Real, kDimensions>& host, CellList<Real, kDimensions, Cuda>& device,
                             NeighboursThere<Layout>& rows, const Points<Real, kDimensions>& points,
                             Stream stream = nullptr) {
  build<Real, kDimensions>(host, points);
  build<Real, kDimensions>(device, points, stream);
  EXPECT_EQ(device.size(), host.size());
  EXPECT_EQ(device.cells(), host.cells());
  EXPECT_EQ(device.order(), host.order());
  for (const OwnEntry own : {OwnEntry::left_out, OwnEntry::included}) {
    Neighbours expected;
    host.find_neighbours(expected, own);
    device.find_neighbours(rows, own, 1 << 30, stream);
    synchronize(stream);
    rows.check();
    const Neighbours found(rows);
    EXPECT_EQ(found.targets().field, expected.targets().field);
    EXPECT_EQ(found.targets().count, expected.targets().count);
    EXPECT_EQ(lists_of(found), lists_of(expected));
  }
}

template <class Real, int kDimensions>
void expect_rows_of_the_host(const Points<Real, kDimensions>& points, const CellBox<Real, kDimensions>& box,
                             Real reach) {
  CellList<Real, kDimensions> host(box, reach);
  CellList<Real, kDimensions, Cuda> device(box, reach);
  NeighboursThere<Soa> rows;
  expect_rows_of_the_host<Soa, Real, kDimensions>(host, device, rows, points);
}

template <class Real, int kDimensions>
void expect_rows_of_the_host_in_boxes() {
  std::uint32_t use = 0;
  for_boxes<Real, kDimensions>([&](const auto& box, Real reach) {
    for (const index_t size : {0, 1, 2, 300}) {
      expect_rows_of_the_host<Real, kDimensions>(random_points<Real, kDimensions>(size, box, reach, use++), box, reach);
    }
  });
}

TEST_F(CudaCellList, has_the_rows_of_the_host_in_boxes_open_and_periodic) {
  expect_rows_of_the_host_in_boxes<float, 1>();
  expect_rows_of_the_host_in_boxes<float, 2>();
  expect_rows_of_the_host_in_boxes<float, 3>();
  expect_rows_of_the_host_in_boxes<double, 1>();
  expect_rows_of_the_host_in_boxes<double, 2>();
  expect_rows_of_the_host_in_boxes<double, 3>();
}

TEST_F(CudaCellList, of_many_objects_and_of_all_in_one_cell_has_the_rows_of_the_host) {
  const CellBox<float> box{.lower = {0, 0, 0}, .upper = {1, 1, 1}, .periodic = {true, false, true}};
  expect_rows_of_the_host<float, 3>(random_points<float, 3>(10000, box, 0.02F, 1000), box, 0.02F);
  std::mt19937 random(seed());
  Points<float, 3> spread(200000);
  for (auto& point : spread) {
    for (float& x : point) x = std::uniform_real_distribution<float>(0, 1)(random);
  }
  expect_rows_of_the_host<float, 3>(spread, box, 0.02F);
  expect_rows_of_the_host<float, 3>(Points<float, 3>(3000, {0.5F, 0.5F, 0.5F}), box, 0.1F);
  const CellBox<float> open{.lower = {0, 0, 0}, .upper = {1, 1, 1}};
  expect_rows_of_the_host<float, 3>(random_points<float, 3>(1000, open, 10.0F, 2000), open, 10.0F);
  const CellBox<double> vast{.lower = {0, 0, 0}, .upper = {1e9, 1e6, 1e9}, .periodic = {true, true, true}};
  expect_rows_of_the_host<double, 3>(random_points<double, 3>(300, vast, 1.0, 3000), vast, 1.0);
}

TEST_F(CudaCellList, is_built_and_searched_again_in_the_same_memory_of_the_device_and_in_a_stream) {
  const CellBox<float> box{.lower = {0, 0, 0}, .upper = {1, 1, 1}};
  CellList<float> host(box, 0.1F);
  CellList<float, 3, Cuda> device(box, 0.1F);
  NeighboursThere<Aosoa<32>> rows;
  cudaStream_t stream = nullptr;
  cuda::check(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), "making a stream");
  const void *ranges = nullptr, *entries = nullptr;
  for (const index_t size : {2000, 1900, 0, 1950}) {
    expect_rows_of_the_host<Aosoa<32>, float, 3>(host, device, rows, random_points<float, 3>(size, box, 0.1F, 4000),
                                                 stream);
    if (size == 2000) {
      ranges = rows.ranges().view().data();
      entries = rows.entries().view().data();
    }
    EXPECT_EQ(rows.ranges().view().data(), ranges);
    EXPECT_EQ(rows.entries().view().data(), entries);
  }
  cudaStreamDestroy(stream);
}

TEST_F(CudaCellList, refuses_what_the_host_refuses_in_its_words_and_stays_as_it_was) {
  const CellBox<float> box{.lower = {0, 0, 0}, .upper = {1, 1, 1}}, none{.lower = {0, 0, 0}, .upper = {1, 0, 1}};
  EXPECT_EQ(message_of([&] { CellList<float, 3, Cuda>(none, 1); }), message_of([&] { CellList<float>(none, 1); }));
  CellList<float> host(box, 0.5F);
  CellList<float, 3, Cuda> device(box, 0.5F);
  NeighboursThere<Soa> rows;
  expect_rows_of_the_host<Soa, float, 3>(host, device, rows, Points<float, 3>(3, {0.5F, 0.25F, 0.125F}));
  const Lists before = lists_of(Neighbours(rows));
  for (const float wrong :
       {-0.25F, 1.5F, std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()}) {
    Points<float, 3> points(5000, {0.5F, 0.25F, 0.125F});
    points[4321] = points[4999] = {0.5F, wrong, 0};
    const auto refused = message_of([&] { build<float, 3>(device, points); });
    EXPECT_NE(refused.find("object 4321"), std::string::npos) << refused;
    EXPECT_EQ(refused, message_of([&] { build<float, 3>(host, points); }));
    device.find_neighbours(rows, OwnEntry::included);
    EXPECT_EQ(lists_of(Neighbours(rows)), before);
  }
  const auto fall_together = [](auto& cells) {
    build<float, 3>(cells, Points<float, 3>(70000, {0.5F, 0.5F, 0.5F}));  // all pairs are more than 2^31 - 1
  };
  fall_together(host);
  fall_together(device);
  for (const index_t most : {1000, 0}) {
    Neighbours rows_here;
    EXPECT_EQ(message_of([&] { device.find_neighbours(rows, OwnEntry::left_out, most); }),
              message_of([&] { host.find_neighbours(rows_here, OwnEntry::left_out, most); }));
    EXPECT_EQ(lists_of(Neighbours(rows)), before);
  }
  const auto too_many = message_of([&] { device.find_neighbours(rows, OwnEntry::left_out, index_t{1} << 40); });
  EXPECT_NE(too_many.find("70000 objects have more than 2147483647 neighbours"), std::string::npos) << too_many;
  EXPECT_EQ(lists_of(Neighbours(rows)), before);
}

}  // namespace
}  // namespace physgen::test
