// Changes of topology in CUDA memory: objects picked by number as plain bytes, and indices renumbered.
#include <physgen/cuda/check.h>
#include <physgen/cuda/parallel_for.h>
#include <physgen/device.h>

#include <algorithm>

#include "../backend/topology.h"
#include "parts/stream_memory.h"

namespace physgen::backend {

namespace {

using cuda::check;
using detail::Addressing;
using detail::Picked;

constexpr int fields_per_launch = 32;

// Moves the elements of one object: neighbouring threads write neighbouring elements of a channel.
struct PickElements {
  Addressing to;
  Addressing from;
  Picked picked;
  index_t begin;
  int count;
  detail::Elements fields[fields_per_launch];

  __device__ void operator()(index_t i) const {
    const index_t j = picked[i];
    for (int f = 0; f < count; ++f) detail::move_elements(to, begin + i, from, j, fields[f]);
  }
};

// Moves one word of one record: neighbouring threads write neighbouring words.
template <int kBytes>
struct PickWords {
  std::byte* to;
  const std::byte* from;
  Picked picked;
  index_t begin;
  int words;  // of a record

  __device__ void operator()(index_t t) const {
    const index_t i = t / words;
    const index_t word = t - i * words;
    detail::move_word<kBytes>(to + ((begin + i) * words + word) * kBytes, from + (picked[i] * words + word) * kBytes);
  }
};

template <int kBytes>
void pick_words(const UntypedArray& to, index_t begin, const UntypedArray& from, const Picked& picked, index_t count,
                Stream stream) {
  const int words = to.record_bytes / kBytes;
  parallel_for(Cuda{}, count * words, PickWords<kBytes>{to.base, from.base, picked, begin, words}, stream);
}

void pick_records(const UntypedArray& to, index_t begin, const UntypedArray& from, const Picked& picked, index_t count,
                  Stream stream) {
  const int bytes = to.record_bytes;
  const auto pick = bytes % 16 == 0  ? pick_words<16>
                    : bytes % 8 == 0 ? pick_words<8>
                    : bytes % 4 == 0 ? pick_words<4>
                                     : pick_words<2>;
  pick(to, begin, from, picked, count, stream);
}

struct FindNotRenumbered {
  detail::Renumbering renumbering;
  unsigned long long* first;

  __device__ void operator()(index_t i) const {
    if (!renumbering.can_renumber(i)) atomicMin(first, static_cast<unsigned long long>(i));
  }
};

}  // namespace

void pick(const UntypedArray& to, index_t begin, const UntypedArray& from, Picked picked, index_t count,
          Stream stream) {
  if (to.pitch == 1 && from.pitch == 1) {
    pick_records(to, begin, from, picked, count, stream);
    return;
  }
  for (std::size_t f = 0; f < to.fields.size();) {
    PickElements kernel{Addressing(to), Addressing(from), picked, begin, 0, {}};
    for (; f < to.fields.size() && kernel.count < fields_per_launch; ++f) {
      if (to.fields[f].is_stored()) kernel.fields[kernel.count++] = detail::Elements(to.fields[f]);
    }
    if (kernel.count > 0) parallel_for(Cuda{}, count, kernel, stream);
  }
}

index_t first_not_renumbered(const detail::Renumbering& renumbering, index_t size) {
  auto first = static_cast<unsigned long long>(size);
  const cuda::StreamMemory memory(sizeof first, nullptr);
  auto* on_device = reinterpret_cast<unsigned long long*>(memory.data());
  check(cudaMemcpyAsync(on_device, &first, sizeof first, cudaMemcpyHostToDevice, nullptr), "preparing a check");
  parallel_for(Cuda{}, size, FindNotRenumbered{renumbering, on_device});
  check(cudaMemcpyAsync(&first, on_device, sizeof first, cudaMemcpyDeviceToHost, nullptr), "checking indices");
  synchronize();
  return static_cast<index_t>(first);
}

void renumber(const detail::Renumbering& renumbering, index_t size) {
  parallel_for(Cuda{}, size, renumbering);
  synchronize();
}

}  // namespace physgen::backend
