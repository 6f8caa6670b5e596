// See host_convert.h. Objects are taken in blocks that stay in the cache, and in each block element by element, so that
// the inner loop runs along the objects with both types known.
#include "host_convert.h"

#include <physgen/detail/host_loop.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "convert.h"
#include "plain_copy.h"
#include "strided.h"

namespace physgen::detail {

namespace {

template <class To, class From, class Convert>
void convert_strided(StridedElements to, StridedElements from, index_t count, const Convert& convert) {
  if (to.stride == index_t{sizeof(To)} && from.stride == index_t{sizeof(From)}) {
    auto* t = reinterpret_cast<To*>(to.first);
    const auto* f = reinterpret_cast<const From*>(from.first);
    for (index_t l = 0; l < count; ++l) t[l] = convert(f[l]);
    return;
  }
  for (index_t l = 0; l < count; ++l) {
    *reinterpret_cast<To*>(to.first + l * to.stride) =
        convert(*reinterpret_cast<const From*>(from.first + l * from.stride));
  }
}

template <class T>
void move_strided(StridedElements to, StridedElements from, index_t count) {
  convert_strided<T, T>(to, from, count, [](T value) { return value; });
}

// Between floats and 16 bits, computed in S: to 16 bits where `narrow` is true, else from them.
template <class S>
void convert_by_codec(const ElementMove& move, bool narrow, StridedElements to, StridedElements from, index_t count) {
  if (narrow) {
    with_codec<S>(move.to, [&](const auto& codec) {
      convert_strided<std::uint16_t, float>(to, from, count,
                                            [&codec](float value) { return codec.encode(static_cast<S>(value)); });
    });
  } else {
    with_codec<S>(move.from, [&](const auto& codec) {
      convert_strided<float, std::uint16_t>(
          to, from, count, [&codec](std::uint16_t bits) { return static_cast<float>(codec.decode(bits)); });
    });
  }
}

/// A move and the bytes of its elements, which short runs must not look up again.
struct SizedMove {
  ElementMove move;
  int to_size = element_bytes(move.to.type), from_size = element_bytes(move.from.type);
};

/// Bytes of every record that move as they are: elements that follow each other on both sides.
struct BytesMove {
  int to_offset, from_offset, bytes;
};

void add_to_runs(std::vector<BytesMove>& runs, const ElementMove& move) {
  const int size = element_bytes(move.to.type);
  if (!runs.empty() && runs.back().to_offset + runs.back().bytes == move.to_offset &&
      runs.back().from_offset + runs.back().bytes == move.from_offset) {
    runs.back().bytes += size;
  } else {
    runs.push_back({move.to_offset, move.from_offset, size});
  }
}

/// Moves runs of kBytes, where these are `bytes`: a call of memcpy() for each record takes longer than its loads and
/// stores.
template <std::size_t kBytes>
bool move_runs_of(std::size_t bytes, StridedElements to, StridedElements from, index_t count) {
  if (bytes != kBytes) return false;
  for (index_t l = 0; l < count; ++l) std::memcpy(to.first + l * to.stride, from.first + l * from.stride, kBytes);
  return true;
}

/// Numbers of bytes that runs often have, of numbers, vectors, symmetric and full matrices, are known to the compiler.
template <std::size_t... kBytes>
void move_runs(std::size_t bytes, StridedElements to, StridedElements from, index_t count) {
  if ((move_runs_of<kBytes>(bytes, to, from, count) || ...)) return;
  for (index_t l = 0; l < count; ++l) std::memcpy(to.first + l * to.stride, from.first + l * from.stride, bytes);
}

void convert_strided(const SizedMove& sized, StridedElements to, StridedElements from, index_t count) {
  const ElementMove& move = sized.move;
  if (move.to == move.from) {
    const int size = sized.to_size;
    if (size == 8) return move_strided<std::uint64_t>(to, from, count);
    if (size == 4) return move_strided<std::uint32_t>(to, from, count);
    if (size == 2) return move_strided<std::uint16_t>(to, from, count);
    return move_strided<std::uint8_t>(to, from, count);
  }
  if (move.to.is_plain(ElementType::float32) && move.from.is_plain(ElementType::float64)) {
    return convert_strided<float, double>(to, from, count, [](double value) { return static_cast<float>(value); });
  }
  if (move.to.is_plain(ElementType::float64) && move.from.is_plain(ElementType::float32)) {
    return convert_strided<double, float>(to, from, count, [](float value) { return static_cast<double>(value); });
  }
  const bool narrow = move.from.is_plain(ElementType::float32) && move.to.has_codec;
  const bool widen = move.to.is_plain(ElementType::float32) && move.from.has_codec;
  if (narrow || widen) {
    return float_suffices(move.to, move.from) ? convert_by_codec<float>(move, narrow, to, from, count)
                                              : convert_by_codec<double>(move, narrow, to, from, count);
  }
  for (index_t l = 0; l < count; ++l) {
    convert_element(to.first + l * to.stride, move.to, from.first + l * from.stride, move.from);
  }
}

}  // namespace

void clear_on_host(std::byte* memory, index_t bytes) {
  constexpr index_t block = 1 << 16;
  for_each_index<block / 64>(0, (bytes + block - 1) / block, [&](index_t b) {
    std::memset(memory + b * block, 0, static_cast<std::size_t>(std::min(block, bytes - b * block)));
  });
}

void convert_on_host(const UntypedArray& to, index_t to_first, const UntypedArray& from, index_t from_first,
                     index_t begin, index_t end) {
  const Addressing to_array(to, to_first), from_array(from, from_first);
  const Conversion conversion(to, from);
  std::vector<SizedMove> elements;
  std::vector<BytesMove> runs;
  for (const ElementMove& move : conversion.elements) {
    if (to_array.records() && from_array.records() && move.to == move.from) {
      add_to_runs(runs, move);
    } else {
      elements.push_back({move});
    }
  }
  const bool whole_records = to_array.records() && from_array.records() && same_records(to, from);
  constexpr index_t block = 1024;
  const index_t blocks = (end - begin + block - 1) / block;
  RegionFailure failure;  // of formats of a program's own
  const auto convert_block = [&](index_t b) {
    const index_t last = std::min(begin + (b + 1) * block, end);
    for (index_t i = begin + b * block; i < last;) {
      const index_t count = std::min({last - i, evenly_spaced(to_array, i), evenly_spaced(from_array, i)});
      if (whole_records) {
        std::memcpy(to_array.address(i, 0, 1), from_array.address(i, 0, 1),
                    static_cast<std::size_t>(count * to.record_bytes));
        i += count;
        continue;
      }
      for (const BytesMove& run : runs) {
        move_runs<2, 4, 8, 12, 16, 24, 32, 36, 48, 72>(static_cast<std::size_t>(run.bytes),
                                                       strided(to_array, i, run.to_offset, run.bytes),
                                                       strided(from_array, i, run.from_offset, run.bytes), count);
      }
      for (const SizedMove& sized : elements) {
        convert_strided(sized, strided(to_array, i, sized.move.to_offset, sized.to_size),
                        strided(from_array, i, sized.move.from_offset, sized.from_size), count);
      }
      for (const RotationMove& move : conversion.rotations) {
        for (index_t l = i; l < i + count; ++l) move.apply(to_array, from_array, l);
      }
      i += count;
    }
  };
  for_each_index<block>(0, blocks, [&](index_t b) { failure.guard([&] { convert_block(b); }); });
  failure.rethrow();
}

Losses count_on_host(const UntypedArray& to, const UntypedArray& from, index_t begin, index_t end) {
  const Addressing array(from);
  const Conversion conversion(to, from);
  Losses losses;
  RegionFailure failure;
  for_each_index(begin, end, [&](index_t i) {
    failure.guard([&] {
      for (const ElementMove& move : conversion.elements) count_element(losses, move, array, i);
      for (const RotationMove& move : conversion.rotations) count_rotation(losses, move, array, i);
      for (const RotationMove& move : conversion.kept_quaternions) count_rotation(losses, move, array, i);
    });
  });
  failure.rethrow();
  return losses;
}

}  // namespace physgen::detail
