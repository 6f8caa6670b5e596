// See transpose.h. The number of elements is a template argument: every address of a thread is then the one before plus
// a constant, and all its loads are under way before the first store.
#include <physgen/cuda/check.h>
#include <physgen/layout/pitch.h>

#include "../../addressing.h"
#include "../../plain_copy.h"
#include "transpose.h"

namespace physgen::cuda {

namespace {

using detail::Addressing;

constexpr int block_objects = 256;

/// The elements of an object in an array that is not made of records.
struct Channels {
  std::byte* first;  // of the object's elements
  index_t step;      // from one element to the next [bytes]

  __device__ Channels(const Addressing& array, index_t i, int size)
      : first(array.address(i, 0, size)), step(law::channel_begin(size, array.pitch)) {}
};

/// Between two arrays in channels. A thread takes as many objects as fill 16 bytes of a channel.
template <class T, int N>
__global__ void __launch_bounds__(block_objects)
    move_channels(const Addressing to, const Addressing from, index_t begin) {
  constexpr int each = 16 / sizeof(T);
  const index_t i = begin + (blockIdx.x * index_t{blockDim.x} + threadIdx.x) * each;
  const Channels source(from, i, sizeof(T)), target(to, i, sizeof(T));
  uint4 values[N];
#pragma unroll
  for (int k = 0; k < N; ++k) values[k] = *reinterpret_cast<const uint4*>(source.first + k * source.step);
#pragma unroll
  for (int k = 0; k < N; ++k) *reinterpret_cast<uint4*>(target.first + k * target.step) = values[k];
}

/// Records in shared memory, as 4-byte words, an odd number of them apart, so that the threads of a warp, each at its
/// own record, meet different banks.
template <class T, int N>
struct Shared {
  static constexpr int words = N * sizeof(T) / 4;
  static constexpr int stride = words | 1;
  static constexpr int vectors = words * block_objects / 4;  // of 16 bytes, in a block

  [[nodiscard]] __device__ static int index_of(int word) { return word + word / words * (stride - words); }
};

template <class T, int N>
__global__ void __launch_bounds__(block_objects)
    from_records(const Addressing to, const Addressing from, index_t begin) {
  using Records = Shared<T, N>;
  __shared__ unsigned shared[Records::stride * block_objects];
  const int t = static_cast<int>(threadIdx.x);
  const index_t block_begin = begin + blockIdx.x * index_t{block_objects};
  const auto* records =
      reinterpret_cast<const uint4*>(from.base + law::tile_begin(block_begin - from.first, index_t{N * sizeof(T)}));
  constexpr int rounds = (Records::vectors + block_objects - 1) / block_objects;
  uint4 loaded[rounds];
#pragma unroll
  for (int r = 0; r < rounds; ++r) {
    if (r * block_objects + t < Records::vectors) loaded[r] = records[r * block_objects + t];
  }
#pragma unroll
  for (int r = 0; r < rounds; ++r) {
    const int word = (r * block_objects + t) * 4;
    if (word >= Records::vectors * 4) continue;
    shared[Records::index_of(word)] = loaded[r].x;
    shared[Records::index_of(word + 1)] = loaded[r].y;
    shared[Records::index_of(word + 2)] = loaded[r].z;
    shared[Records::index_of(word + 3)] = loaded[r].w;
  }
  __syncthreads();
  const Channels target(to, block_begin + t, sizeof(T));
  const unsigned* record = shared + t * Records::stride;
#pragma unroll
  for (int k = 0; k < N; ++k) {
    if constexpr (sizeof(T) == 4) {
      *reinterpret_cast<unsigned*>(target.first + k * target.step) = record[k];
    } else {
      *reinterpret_cast<uint2*>(target.first + k * target.step) = {record[2 * k], record[2 * k + 1]};
    }
  }
}

template <class T, int N>
__global__ void __launch_bounds__(block_objects) to_records(const Addressing to, const Addressing from, index_t begin) {
  using Records = Shared<T, N>;
  __shared__ unsigned shared[Records::stride * block_objects];
  const int t = static_cast<int>(threadIdx.x);
  const index_t block_begin = begin + blockIdx.x * index_t{block_objects};
  const Channels source(from, block_begin + t, sizeof(T));
  unsigned* record = shared + t * Records::stride;
  T values[N];
#pragma unroll
  for (int k = 0; k < N; ++k) values[k] = *reinterpret_cast<const T*>(source.first + k * source.step);
#pragma unroll
  for (int k = 0; k < N; ++k) {
    if constexpr (sizeof(T) == 4) {
      record[k] = values[k];
    } else {
      record[2 * k] = static_cast<unsigned>(values[k]);
      record[2 * k + 1] = static_cast<unsigned>(values[k] >> 32);
    }
  }
  __syncthreads();
  auto* records = reinterpret_cast<uint4*>(to.base + law::tile_begin(block_begin - to.first, index_t{N * sizeof(T)}));
#pragma unroll
  for (int v = t; v < Records::vectors; v += block_objects) {
    records[v] = {shared[Records::index_of(4 * v)], shared[Records::index_of(4 * v + 1)],
                  shared[Records::index_of(4 * v + 2)], shared[Records::index_of(4 * v + 3)]};
  }
}

template <class T, int N>
void launch(const Addressing& to, const Addressing& from, index_t begin, index_t objects, Stream stream) {
  const auto blocks = static_cast<unsigned>(objects / block_objects);
  if (from.records()) {
    from_records<T, N><<<blocks, block_objects, 0, stream>>>(to, from, begin);
  } else if (to.records()) {
    to_records<T, N><<<blocks, block_objects, 0, stream>>>(to, from, begin);
  } else {
    constexpr int each = 16 / sizeof(T);
    move_channels<T, N><<<blocks, block_objects / each, 0, stream>>>(to, from, begin);
  }
  check(cudaGetLastError(), "launching a transposition");
}

using Launch = void (*)(const Addressing&, const Addressing&, index_t, index_t, Stream);

template <class T, int... N>
Launch find(int elements, std::integer_sequence<int, N...> /*counts*/) {
  Launch found = nullptr;
  ((elements == N + 1 ? found = launch<T, N + 1> : nullptr), ...);
  return found;
}

// A channel's 16 bytes never leave its tile.
[[nodiscard]] bool wide_tiles(const UntypedArray& array) { return array.pitch == 1 || array.pitch % 4 == 0; }

}  // namespace

index_t transpose(const UntypedArray& to, index_t to_first, const UntypedArray& from, index_t from_first, index_t begin,
                  index_t end, Stream stream) {
  const index_t objects = (end - begin) / block_objects * block_objects;
  const bool both_records = to.pitch == 1 && from.pitch == 1;
  if (objects == 0 || begin % padding_objects != 0 || both_records || !detail::same_records(to, from) ||
      !wide_tiles(to) || !wide_tiles(from)) {
    return begin;
  }
  int elements = 0, size = 0;
  for (const FieldInfo& field : to.fields) {
    if (!field.is_stored()) continue;
    if (size == 0) size = element_bytes(field.type);
    if (element_bytes(field.type) != size) return begin;
    elements += field.count;
  }
  if (size < 4 || elements > 16 || elements * size != to.record_bytes) return begin;
  constexpr auto counts = std::make_integer_sequence<int, 16>();
  const Launch launch = size == 4 ? find<std::uint32_t>(elements, counts) : find<unsigned long long>(elements, counts);
  launch(Addressing(to, to_first), Addressing(from, from_first), begin, objects, stream);
  return begin + objects;
}

}  // namespace physgen::cuda
