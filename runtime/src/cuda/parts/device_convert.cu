// See device_convert.h. A thread takes one object and goes along its elements, so that tiled channels are read and
// written as whole sectors; records of an array of structs are staged.
#include <physgen/cuda/check.h>
#include <physgen/layout/pitch.h>

#include <algorithm>
#include <array>

#include "device_convert.h"
#include "moves.h"
#include "staging.h"
#include "transpose.h"

namespace physgen {

namespace {

using cuda::blocks_for;
using cuda::check;
using cuda::for_each_part;
using cuda::move_records;
using cuda::Moves;
using cuda::moves_per_launch;
using cuda::ObjectElements;
using cuda::read;
using cuda::Staged;
using cuda::threads;
using cuda::write;
using detail::Addressing;
using detail::ElementMove;

struct Block {
  index_t begin;        // first object of the launch, a multiple of 32
  index_t first, last;  // objects to be converted, first .. last - 1
  Staged from, to;
  bool clear;  // elements do not fill the target's records
};

// Calls write(e, read(e)) for the elements e = 0 .. count-1, and reads kBatch of them before it writes the first.
template <class Value, int kBatch, class Read, class Write>
__device__ void in_batches(int count, const Read& read, const Write& write) {
  for (int first = 0; first < count; first += kBatch) {
    Value value[kBatch];
#pragma unroll
    for (int k = 0; k < kBatch; ++k) {
      if (first + k < count) value[k] = read(first + k);
    }
#pragma unroll
    for (int k = 0; k < kBatch; ++k) {
      if (first + k < count) write(first + k, value[k]);
    }
  }
}

// Moves elements as words of type T.
template <class T, bool kFromStaged, bool kToStaged>
__device__ void move_words(const Moves& moves, const ObjectElements<kFromStaged>& from,
                           const ObjectElements<kToStaged>& to) {
  constexpr int size = sizeof(T);
  in_batches<T, 16>(
      moves.elements, [&](int e) { return read<kFromStaged, T>(from.at(moves.element[e].from_offset, size)); },
      [&](int e, T value) { write<kToStaged, T>(to.at(moves.element[e].to_offset, size), value); });
}

// Converts between floats and 16 bits of one format: kNarrow to 16 bits, else from them.
template <bool kNarrow, bool kFromStaged, bool kToStaged>
__device__ void convert_uniform(const Moves& moves, const ObjectElements<kFromStaged>& from,
                                const ObjectElements<kToStaged>& to) {
  using From = std::conditional_t<kNarrow, float, unsigned short>;
  constexpr int from_size = sizeof(From), to_size = kNarrow ? 2 : 4;
  detail::with_codec<float>(kNarrow ? moves.element[0].to : moves.element[0].from, [&](const auto& codec) {
    in_batches<From, 16>(
        moves.elements,
        [&](int e) { return read<kFromStaged, From>(from.at(moves.element[e].from_offset, from_size)); },
        [&](int e, From value) {
          std::byte* target = to.at(moves.element[e].to_offset, to_size);
          if constexpr (kNarrow) {
            write<kToStaged, unsigned short>(target, codec.encode(value));
          } else {
            write<kToStaged, float>(target, codec.decode(value));
          }
        });
  });
}

template <bool kFromStaged, bool kToStaged>
__device__ void convert_elements(const Moves& moves, const ObjectElements<kFromStaged>& from,
                                 const ObjectElements<kToStaged>& to) {
  const auto bits_of = [&](int e) -> unsigned long long {
    const ElementMove& move = moves.element[e];
    const int size = element_bytes(move.from.type);
    const std::byte* source = from.at(move.from_offset, size);
    if (size == 8) return read<kFromStaged, unsigned long long>(source);
    if (size == 4) return read<kFromStaged, unsigned>(source);
    if (size == 2) return read<kFromStaged, unsigned short>(source);
    return read<kFromStaged, unsigned char>(source);
  };
  in_batches<unsigned long long, 4>(moves.elements, bits_of, [&](int e, const unsigned long long& bits) {
    const ElementMove& move = moves.element[e];
    const int size = element_bytes(move.to.type);
    unsigned long long out = 0;
    detail::convert_element(reinterpret_cast<std::byte*>(&out), move.to, reinterpret_cast<const std::byte*>(&bits),
                            move.from);
    std::byte* target = to.at(move.to_offset, size);
    if (size == 8) return write<kToStaged>(target, out);
    if (size == 4) return write<kToStaged>(target, static_cast<unsigned>(out));
    if (size == 2) return write<kToStaged>(target, static_cast<unsigned short>(out));
    write<kToStaged>(target, static_cast<unsigned char>(out));
  });
}

// The elements of a launch have this in common.
enum class Kind { words4, words2, narrow, widen, any };  // in the order of `launches`

template <Kind kKind, bool kFromStaged, bool kToStaged>
__global__ void convert_kernel(const Addressing to, const Addressing from, const __grid_constant__ Moves moves,
                               const Block block) {
  extern __shared__ unsigned shared[];
  unsigned* const from_shared = shared;
  unsigned* const to_shared = shared + (kFromStaged ? static_cast<int>(blockDim.x) * block.from.stride : 0);
  const index_t block_begin = block.begin + blockIdx.x * index_t{blockDim.x};
  const auto lo = static_cast<int>(max(block.first, block_begin) - block_begin);
  const auto hi = static_cast<int>(min(block.last, block_begin + index_t{blockDim.x}) - block_begin);
  if constexpr (kFromStaged) {
    move_records<true>(block.from, from_shared, from.record(block_begin), lo * block.from.words, hi * block.from.words);
  }
  if constexpr (kToStaged) {  // padding of records, and what is converted later, is zero until then
    const int words = block.to.stride * static_cast<int>(blockDim.x);
    for (int w = static_cast<int>(threadIdx.x); block.clear && w < words; w += static_cast<int>(blockDim.x)) {
      to_shared[w] = 0;
    }
  }
  if (kFromStaged || block.clear) __syncthreads();
  const int thread = static_cast<int>(threadIdx.x);
  if (thread >= lo && thread < hi) {
    const index_t i = block_begin + thread;
    const ObjectElements<kFromStaged> source(from, block.from, from_shared, i, thread);
    const ObjectElements<kToStaged> target(to, block.to, to_shared, i, thread);
    if constexpr (kKind == Kind::words4) {
      move_words<unsigned>(moves, source, target);
    } else if constexpr (kKind == Kind::words2) {
      move_words<unsigned short>(moves, source, target);
    } else if constexpr (kKind == Kind::narrow || kKind == Kind::widen) {
      convert_uniform<kKind == Kind::narrow>(moves, source, target);
    } else {
      convert_elements(moves, source, target);
    }
  }
  if constexpr (kToStaged) {
    __syncthreads();
    move_records<false>(block.to, to_shared, to.record(block_begin), lo * block.to.words, hi * block.to.words);
  }
}

// Rotations that change their form are few bytes and much arithmetic: they go from memory to memory.
__global__ void convert_rotations(const Addressing to, const Addressing from, const __grid_constant__ Moves moves,
                                  index_t begin, index_t end) {
  const index_t i = begin + blockIdx.x * index_t{blockDim.x} + threadIdx.x;
  if (i >= end) return;
  for (int r = 0; r < moves.rotations; ++r) moves.rotation[r].apply(to, from, i);
}

[[nodiscard]] Kind kind_of(const Moves& moves) {
  const detail::FieldFormat &to = moves.element[0].to, &from = moves.element[0].from;
  const bool uniform = std::all_of(moves.element, moves.element + moves.elements,
                                   [&](const ElementMove& move) { return move.to == to && move.from == from; });
  const auto all_moved = [&](int size) {
    return std::all_of(moves.element, moves.element + moves.elements, [size](const ElementMove& move) {
      return move.to == move.from && element_bytes(move.to.type) == size;
    });
  };
  if (all_moved(4)) return Kind::words4;
  if (all_moved(2)) return Kind::words2;
  const bool in_float = uniform && detail::float_suffices(to, from);
  if (in_float && from.is_plain(ElementType::float32) && to.has_codec) return Kind::narrow;
  if (in_float && to.is_plain(ElementType::float32) && from.has_codec) return Kind::widen;
  return Kind::any;
}

constexpr int most_shared = 48 * 1024;  // [bytes] what every kernel may use

template <Kind kKind>
void launch(const Addressing& to, const Addressing& from, const Moves& moves, const Block& block, cudaStream_t stream) {
  int objects = threads;
  while (block.from.shared_bytes(objects) + block.to.shared_bytes(objects) > most_shared) objects /= 2;
  const int shared = block.from.shared_bytes(objects) + block.to.shared_bytes(objects);
  const unsigned grid = blocks_for(block.last - block.begin, objects);
  const bool from_staged = block.from.words > 0, to_staged = block.to.words > 0;
  auto* const kernel = from_staged && to_staged ? convert_kernel<kKind, true, true>
                       : from_staged            ? convert_kernel<kKind, true, false>
                       : to_staged              ? convert_kernel<kKind, false, true>
                                                : convert_kernel<kKind, false, false>;
  kernel<<<grid, objects, shared, stream>>>(to, from, moves, block);
  check(cudaGetLastError(), "launching a conversion");
}

}  // namespace

void cuda::convert(const UntypedArray& to, index_t to_first, const UntypedArray& from, index_t from_first,
                   index_t begin, index_t end, Stream stream) {
  const index_t aligned = align_up(begin, padding_objects);
  if (begin < aligned && aligned < end) {  // whole tiles, which have faster ways, begin later
    convert(to, to_first, from, from_first, begin, aligned, stream);
    convert(to, to_first, from, from_first, aligned, end, stream);
    return;
  }
  begin = transpose(to, to_first, from, from_first, begin, end, stream);
  if (begin == end) return;
  const Addressing to_array(to, to_first), from_array(from, from_first);
  const detail::Conversion conversion(to, from);
  // Records are staged whole where they are made of 4-byte words and those of 32 objects fit; the target's only when
  // one launch has all their elements, since what was there before is lost.
  const auto can_stage = [](const UntypedArray& array) {
    return array.pitch == 1 && array.record_bytes % 4 == 0 && array.record_bytes <= most_shared / 2 / 32 - 4;
  };
  int element_bytes_written = 0;
  for (const ElementMove& move : conversion.elements) element_bytes_written += element_bytes(move.to.type);
  const bool stage_to = can_stage(to) && conversion.elements.size() <= moves_per_launch;
  const Block block{begin / 32 * 32,
                    begin,
                    end,
                    Staged::of(from, can_stage(from)),
                    Staged::of(to, stage_to),
                    stage_to && element_bytes_written != to.record_bytes};
  for_each_part(conversion, [&](const Moves& moves) {
    if (moves.elements > 0) {
      constexpr std::array launches{launch<Kind::words4>, launch<Kind::words2>, launch<Kind::narrow>,
                                    launch<Kind::widen>, launch<Kind::any>};
      launches[static_cast<std::size_t>(kind_of(moves))](to_array, from_array, moves, block, stream);
    }
    if (moves.rotations > 0) {
      convert_rotations<<<blocks_for(end - begin, threads), threads, 0, stream>>>(to_array, from_array, moves, begin,
                                                                                  end);
      check(cudaGetLastError(), "launching a conversion of rotations");
    }
  });
}

}  // namespace physgen
