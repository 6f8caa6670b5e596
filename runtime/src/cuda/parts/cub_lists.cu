// See cub_lists.h. One instance of each algorithm of CUB serves lists of all types.
#include <physgen/cuda/check.h>
#include <physgen/device.h>

#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_reduce.cuh>
#include <cub/device/device_scan.cuh>
#include <iterator>

#include "cub_lists.h"

namespace physgen::cuda {

namespace {

/// The numbers of a list as index_t, which CUB reads and writes.
class NumberIterator {
 public:
  /// One of them.
  class Reference {
   public:
    PHYSGEN_FUNCTION Reference(const detail::NumberList& list, index_t at) : list_(list), at_(at) {}
    PHYSGEN_FUNCTION operator index_t() const { return list_.get(at_); }  // NOLINT(google-explicit-constructor)
    PHYSGEN_FUNCTION const Reference& operator=(index_t number) const {
      list_.put(at_, number);
      return *this;
    }

   private:
    detail::NumberList list_;
    index_t at_;
  };
  using iterator_category = std::random_access_iterator_tag;
  using value_type = index_t;
  using difference_type = index_t;
  using pointer = index_t*;
  using reference = Reference;

  PHYSGEN_FUNCTION NumberIterator(const detail::NumberList& list, index_t at) : list_(list), at_(at) {}
  [[nodiscard]] PHYSGEN_FUNCTION Reference operator*() const { return {list_, at_}; }
  [[nodiscard]] PHYSGEN_FUNCTION Reference operator[](index_t i) const { return {list_, at_ + i}; }
  [[nodiscard]] PHYSGEN_FUNCTION NumberIterator operator+(index_t i) const { return {list_, at_ + i}; }

 private:
  detail::NumberList list_;
  index_t at_;
};

struct Add {
  PHYSGEN_FUNCTION index_t operator()(index_t a, index_t b) const { return a + b; }
};

constexpr index_t most_at_once = index_t{1} << 30;  // earlier versions of CUB count in int
constexpr index_t for_result = 256;                 // bytes in front of CUB's

/// Calls part(begin, count) for parts that CUB can count.
template <class Part>
void for_each_part(index_t size, const Part& part) {
  for (index_t begin = 0; begin < size; begin += most_at_once) {
    part(begin, static_cast<int>(std::min(size - begin, most_at_once)));
  }
}

cudaError_t reduce(void* memory, std::size_t& bytes, const NumberIterator& numbers, index_t* total, int count,
                   Stream stream) {
  return cub::DeviceReduce::Reduce(memory, bytes, numbers, total, count, Add(), index_t{0}, stream);
}
cudaError_t scan(void* memory, std::size_t& bytes, const NumberIterator& numbers, index_t before, int count,
                 Stream stream) {
  return cub::DeviceScan::ExclusiveScan(memory, bytes, numbers, numbers, Add(), before, count, stream);
}

index_t part_sum(const NumberIterator& numbers, int count, const Workspace& workspace, Stream stream) {
  auto* const on_device = reinterpret_cast<index_t*>(workspace.data);
  auto bytes = static_cast<std::size_t>(workspace.bytes - for_result);
  check(reduce(workspace.data + for_result, bytes, numbers, on_device, count, stream), "adding up a list");
  index_t total = 0;
  check(cudaMemcpyAsync(&total, on_device, sizeof total, cudaMemcpyDeviceToHost, stream), "adding up a list");
  synchronize(stream);
  return total;
}

}  // namespace

index_t workspace_of_scan(const detail::NumberList& numbers) {
  const NumberIterator begin(numbers, 0);
  const int count = static_cast<int>(std::min(numbers.size, most_at_once));
  std::size_t for_sum = 0, for_scan = 0;
  check(reduce(nullptr, for_sum, begin, nullptr, count, nullptr), "adding up a list");
  check(scan(nullptr, for_scan, begin, 0, count, nullptr), "scanning a list");
  return static_cast<index_t>(std::max(for_sum, for_scan)) + for_result;
}

index_t sum(const detail::NumberList& numbers, const Workspace& workspace, Stream stream) {
  index_t total = 0;
  for_each_part(numbers.size, [&](index_t begin, int count) {
    total += part_sum(NumberIterator(numbers, begin), count, workspace, stream);
  });
  return total;
}

void scan(const detail::NumberList& numbers, const Workspace& workspace, Stream stream) {
  index_t before = 0;
  for_each_part(numbers.size, [&](index_t begin, int count) {
    const NumberIterator part(numbers, begin);
    const bool last = begin + count == numbers.size;
    const index_t behind = last ? 0 : before + part_sum(part, count, workspace, stream);
    auto bytes = static_cast<std::size_t>(workspace.bytes - for_result);
    check(scan(workspace.data + for_result, bytes, part, before, count, stream), "scanning a list");
    before = behind;
  });
}

template <class Key>
index_t workspace_of_sort(index_t size) {
  cub::DoubleBuffer<Key> keys(nullptr, nullptr);
  cub::DoubleBuffer<std::uint32_t> values(nullptr, nullptr);
  std::size_t bytes = 0;
  check(cub::DeviceRadixSort::SortPairs(nullptr, bytes, keys, values, static_cast<std::uint32_t>(size)),
        "sorting a list");
  return static_cast<index_t>(bytes);
}

template <class Key>
void sort(Pairs<Key>& pairs, int bits, const Workspace& workspace, Stream stream) {
  cub::DoubleBuffer<Key> keys(pairs.keys, pairs.other_keys);
  cub::DoubleBuffer<std::uint32_t> values(pairs.values, pairs.other_values);
  auto bytes = static_cast<std::size_t>(workspace.bytes);
  check(cub::DeviceRadixSort::SortPairs(workspace.data, bytes, keys, values, static_cast<std::uint32_t>(pairs.size), 0,
                                        bits, stream),
        "sorting a list");
  pairs = {keys.Current(), keys.Alternate(), values.Current(), values.Alternate(), pairs.size};
}

template index_t workspace_of_sort<std::uint32_t>(index_t size);
template index_t workspace_of_sort<std::uint64_t>(index_t size);
template void sort(Pairs<std::uint32_t>& pairs, int bits, const Workspace& workspace, Stream stream);
template void sort(Pairs<std::uint64_t>& pairs, int bits, const Workspace& workspace, Stream stream);

}  // namespace physgen::cuda
