// Records of an array of structs in shared memory. A thread that goes along the elements of its object would tear them
// apart in memory: a block brings those of its objects in, or out, in 16-byte words.
#pragma once

#include <bit>
#include <cstddef>

#include "../../addressing.h"

namespace physgen::cuda {

/// Records of the objects of a block in shared memory. Their 4-byte words are an odd number apart, so that the threads
/// of a warp, each at its own record, meet different banks.
struct Staged {
  int words;       // of a record; 0: not staged
  int stride;      // from one record to the next [words]
  unsigned magic;  // word / words = the upper half of word * magic, for words of a block

  static Staged of(const UntypedArray& array, bool staged) {
    Staged result{0, 0, 0};
    if (!staged) return result;
    result.words = array.record_bytes / 4;
    result.stride = result.words | 1;
    result.magic = static_cast<unsigned>((0xffffffffULL + static_cast<unsigned>(result.words)) /
                                         static_cast<unsigned>(result.words));
    return result;
  }
  [[nodiscard]] __device__ int index_of(int word) const {
    const int record = words == 1 ? word : static_cast<int>(__umulhi(static_cast<unsigned>(word), magic));
    return word + record * (stride - words);
  }
  [[nodiscard]] int shared_bytes(int objects) const { return objects * stride * 4; }
};

/// Words of the block's records, from or to memory that begins at a multiple of 16 bytes.
template <bool kIn>
__device__ void move_records(const Staged& staged, unsigned* shared, std::byte* memory, int words_begin,
                             int words_end) {
  auto* words = reinterpret_cast<unsigned*>(memory);
  const int whole_begin = (words_begin + 3) & ~3, whole_end = words_end & ~3;
  for (int w = whole_begin + static_cast<int>(threadIdx.x) * 4; w < whole_end; w += static_cast<int>(blockDim.x) * 4) {
    auto* wide = reinterpret_cast<uint4*>(words + w);
    if constexpr (kIn) {
      const uint4 four = *wide;
      shared[staged.index_of(w)] = four.x;
      shared[staged.index_of(w + 1)] = four.y;
      shared[staged.index_of(w + 2)] = four.z;
      shared[staged.index_of(w + 3)] = four.w;
    } else {
      *wide = {shared[staged.index_of(w)], shared[staged.index_of(w + 1)], shared[staged.index_of(w + 2)],
               shared[staged.index_of(w + 3)]};
    }
  }
  const auto single = [&](int w) {
    if constexpr (kIn) {
      shared[staged.index_of(w)] = words[w];
    } else {
      words[w] = shared[staged.index_of(w)];
    }
  };
  const int before = min(whole_begin, words_end);
  for (int w = words_begin + static_cast<int>(threadIdx.x); w < before; w += static_cast<int>(blockDim.x)) single(w);
  for (int w = max(whole_end, before) + static_cast<int>(threadIdx.x); w < words_end; w += static_cast<int>(blockDim.x))
    single(w);
}

/// The elements of one object, which lie in memory, or in its record in shared memory.
template <bool kStaged>
struct ObjectElements {
  std::byte* object;
  index_t pitch;
  index_t lane;
  __device__ ObjectElements(const detail::Addressing& array, const Staged& staged, unsigned* shared, index_t i,
                            int record) {
    if constexpr (kStaged) {
      object = reinterpret_cast<std::byte*>(shared + record * staged.stride);
      pitch = 1;
      lane = 0;
    } else {
      object = array.tile_of(i);
      pitch = array.pitch;
      lane = array.lane(i);
    }
  }
  [[nodiscard]] __device__ std::byte* at(int offset, int size) const {
    return object + law::channel_begin(offset, pitch) + law::lane_begin(lane, size);
  }
};

/// Shared records are aligned to 4 bytes only, so an 8-byte element is moved as two words.
template <bool kStaged, class T>
__device__ T read(const std::byte* from) {
  if constexpr (kStaged && sizeof(T) == 8) {
    const auto* words = reinterpret_cast<const unsigned*>(from);
    return std::bit_cast<T>(static_cast<unsigned long long>(words[1]) << 32 | words[0]);
  } else {
    return *reinterpret_cast<const T*>(from);
  }
}
template <bool kStaged, class T>
__device__ void write(std::byte* to, T value) {
  if constexpr (kStaged && sizeof(T) == 8) {
    const auto bits = std::bit_cast<unsigned long long>(value);
    auto* words = reinterpret_cast<unsigned*>(to);
    words[0] = static_cast<unsigned>(bits);
    words[1] = static_cast<unsigned>(bits >> 32);
  } else {
    *reinterpret_cast<T*>(to) = value;
  }
}

}  // namespace physgen::cuda
