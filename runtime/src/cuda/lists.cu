// Scans and sorts of lists in CUDA memory.
#include <physgen/cuda/check.h>
#include <physgen/cuda/parallel_for.h>
#include <physgen/detail/scan.h>

#include <limits>

#include "../element_codec.h"
#include "parts/cub_lists.h"
#include "parts/stream_memory.h"

namespace physgen::detail {

namespace {

using cuda::check;

/// The keys as bits that ascend as they do, and their order so far.
template <class Bits>
struct ReadKeys {
  NumberList keys;
  Bits mask, sign;
  Bits* bits;
  std::uint32_t* order;  // null: not wanted

  __device__ void operator()(index_t i) const {
    bits[i] = (static_cast<Bits>(keys.get(i)) & mask) ^ sign;
    if (order != nullptr) order[i] = static_cast<std::uint32_t>(i);
  }
};

template <class Bits>
struct WriteKeys {
  NumberList keys;
  Bits sign;
  const Bits* bits;

  __device__ void operator()(index_t i) const { keys.put(i, static_cast<index_t>(bits[i] ^ sign)); }
};

/// Value i becomes value order[i]. Moves one word: neighbouring threads write neighbouring words.
template <int kBytes>
struct MoveWords {
  std::byte* to;
  const std::byte* from;
  const std::uint32_t* order;
  int words;  // of a value

  __device__ void operator()(index_t t) const {
    const index_t i = t / words, word = t - i * words;
    move_word<kBytes>(to + t * kBytes, from + (index_t{order[i]} * words + word) * kBytes);
  }
};

template <int kBytes>
void move_words(const ValueList& to, const std::byte* from, const std::uint32_t* order, index_t size, Stream stream) {
  const int words = to.bytes / kBytes;
  parallel_for(Cuda{}, size * words, MoveWords<kBytes>{to.data, from, order, words}, stream);
}

void move_values(const ValueList& to, const std::byte* from, const std::uint32_t* order, index_t size, Stream stream) {
  const auto move = to.word == 16  ? move_words<16>
                    : to.word == 8 ? move_words<8>
                    : to.word == 4 ? move_words<4>
                    : to.word == 2 ? move_words<2>
                                   : move_words<1>;
  move(to, from, order, size, stream);
}

void copy_values(void* to, const void* from, index_t bytes, Stream stream) {
  check(cudaMemcpyAsync(to, from, static_cast<std::size_t>(bytes), cudaMemcpyDeviceToDevice, stream), "sorting a list");
}

/// Values of 32 bits go along with the keys; in place of others go their numbers.
template <class Bits>
void sort_as(const NumberList& keys, const ValueList& values, Stream stream) {
  const index_t size = keys.size, value_bytes = size * values.bytes;
  const bool along = values.bytes == sizeof(std::uint32_t) && values.word == values.bytes;
  const index_t work_bytes = cuda::workspace_of_sort<Bits>(size);
  cuda::Pairs<Bits> pairs{};
  cuda::Workspace workspace{};
  std::byte* other_values = nullptr;
  const auto take_from = [&](std::byte* memory) {
    cuda::Lists lists(memory);
    pairs = {lists.take<Bits>(size), lists.take<Bits>(size), lists.take<std::uint32_t>(size),
             lists.take<std::uint32_t>(size), size};
    workspace = {lists.take<std::byte>(work_bytes), work_bytes};
    if (!along) other_values = lists.take<std::byte>(value_bytes);
    return lists.used();
  };
  const cuda::StreamMemory memory(take_from(nullptr), stream);
  take_from(memory.data());
  const int bits = 8 * keys.bytes;
  const auto mask = static_cast<Bits>(~std::uint64_t{0} >> (64 - bits)), sign = static_cast<Bits>(keys.sign());
  parallel_for(Cuda{}, size, ReadKeys<Bits>{keys, mask, sign, pairs.keys, along ? nullptr : pairs.values}, stream);
  copy_values(along ? static_cast<void*>(pairs.values) : other_values, values.data, value_bytes, stream);
  cuda::sort(pairs, bits, workspace, stream);
  parallel_for(Cuda{}, size, WriteKeys<Bits>{keys, sign, pairs.keys}, stream);
  if (along) {
    copy_values(values.data, pairs.values, value_bytes, stream);
  } else {
    move_values(values, other_values, pairs.values, size, stream);
  }
}

}  // namespace

index_t scan(const NumberList& numbers, Stream stream) {
  if (numbers.size == 0) return 0;
  const index_t bytes = cuda::workspace_of_scan(numbers);
  const cuda::StreamMemory memory(bytes, stream);
  const cuda::Workspace workspace{memory.data(), bytes};
  const index_t total = cuda::sum(numbers, workspace, stream);
  check_total(total, numbers.most());
  cuda::scan(numbers, workspace, stream);
  return total;
}

void sort(const NumberList& keys, const ValueList& values, Stream stream) {
  if (keys.size < 2) return;
  constexpr index_t most = std::numeric_limits<std::uint32_t>::max();
  if (keys.size > most) {
    throw Error("sort_by_key(): there are " + std::to_string(keys.size) + " keys, and a device sorts up to " +
                std::to_string(most) + " at once; sort parts of them");
  }
  if (keys.bytes > 4) {
    sort_as<std::uint64_t>(keys, values, stream);
  } else {
    sort_as<std::uint32_t>(keys, values, stream);
  }
}

}  // namespace physgen::detail
