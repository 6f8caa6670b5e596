// Reductions on the CPU, block by block, in the order of reduce.h.
#pragma once

#include <physgen/detail/kernel_calls.h>
#include <physgen/launch/reduce.h>

#include <algorithm>
#include <array>

namespace physgen::detail {

/// The numbers of an entry, lane by lane.
template <class Entry, class Number>
void store_numbers(const Entry& entry, Number* numbers) {
  if constexpr (std::is_arithmetic_v<Entry>) {
    *numbers = entry;
  } else {
    entry.store_unaligned(numbers);
  }
}

/// Lane 0 gets all.
template <class Fold, class Value>
Value join_lanes(Value* lanes) {
  for (int step = reduce_lanes / 2; step > 0; step /= 2) {
    for (int l = 0; l < step; ++l) lanes[l] = Fold::join(lanes[l], lanes[l + step]);
  }
  return lanes[0];
}

/// The value of blocks that have these.
template <class Fold, class Number, class Value>
Value join_blocks(const Value* values, index_t blocks) {
  std::array<Value, reduce_strands> strands;
  const auto count = static_cast<std::size_t>(std::min(blocks, index_t{reduce_strands}));
  strands[0] = Fold::template identity<Number>();
  for (std::size_t s = 0; s < count; ++s) {
    strands[s] = Fold::template identity<Number>();
    for (index_t b = static_cast<index_t>(s); b < blocks; b += reduce_strands) {
      strands[s] = Fold::join(strands[s], values[b]);
    }
  }
  for (std::size_t step = reduce_strands / 2; step > 0; step /= 2) {
    for (std::size_t s = 0; s < step && s + step < count; ++s) strands[s] = Fold::join(strands[s], strands[s + step]);
  }
  return strands[0];
}

/// Holds back compilers that would fuse a kernel's last product with the sum that it joins, which changes its bits.
template <class Numbers>
void keep_apart([[maybe_unused]] Numbers& numbers) {
#ifdef __GNUC__
  asm volatile("" : "+m"(numbers));
#endif
}

/// The values of the objects begin .. end-1, which lie in one block, an entry each. The numbers of 32 objects are
/// collected, then joined to the lanes at once: a loop that compilers turn into packs, whatever the fold.
/// @param shift folds know object i by the number i + shift
template <class Fold, int kWidth, class Kernel, class Value>
void reduce_one_block(index_t begin, index_t end, const Kernel& kernel, LaunchFailure& failure, index_t shift,
                      Value* values) {
  using Index = std::conditional_t<kWidth == 1, index_t, Pack<kWidth>>;
  using Types = Reduction<Kernel, Fold, Index>;
  static_assert(kWidth == 1 || !std::is_arithmetic_v<typename Types::Entries::Entry>,
                "a kernel over packs returned one plain number for W objects: return a batch, `S(1)` with "
                "S = lanes_t<Scalar, I>, or a mask, `m > S(0)`");
  using Number = typename Types::Number;
  constexpr auto count = static_cast<std::size_t>(Types::count);
  alignas(64) std::array<std::array<Value, reduce_lanes>, count> lanes;
  alignas(64) std::array<std::array<Number, reduce_lanes>, count> numbers{};
  for (auto& entry : lanes) entry.fill(Fold::template identity<Number>());
  // lane0: the object of lane 0
  for (index_t lane0 = begin / reduce_lanes * reduce_lanes; lane0 < end; lane0 += reduce_lanes) {
    const auto call = [&](const auto& i, index_t at) {
      call_guarded(i, failure, [&] {
        const typename Reduction<Kernel, Fold, std::remove_cvref_t<decltype(i)>>::Term term = kernel(i);
        for (std::size_t k = 0; k < count; ++k) {
          store_numbers(Types::Entries::entry(term, static_cast<int>(k)), numbers[k].data() + (at - lane0));
        }
      });
    };
    const auto join = [&](std::size_t l) {
      for (std::size_t k = 0; k < count; ++k) {
        const Value value = Fold::template value<Number>(numbers[k][l], lane0 + static_cast<index_t>(l) + shift);
        lanes[k][l] = Fold::join(lanes[k][l], value);
      }
    };
    if (begin <= lane0 && lane0 + reduce_lanes <= end) {
      for (index_t at = lane0; at < lane0 + reduce_lanes; at += kWidth) call(Index{at}, at);
      keep_apart(numbers);
      for (std::size_t l = 0; l < reduce_lanes; ++l) join(l);
      continue;
    }
    const index_t first = std::max(lane0, begin), last = std::min(lane0 + reduce_lanes, end);
    for (index_t at = first / kWidth * kWidth; at < last; at += kWidth) {
      if constexpr (kWidth == 1) {
        call(at, at);
      } else {  // also where all of the pack is in the range: the kernel's code stands here twice, not three times
        call(PartialPack<kWidth>{at, static_cast<int>(std::max(first - at, index_t{0})),
                                 static_cast<int>(std::min(last - at, index_t{kWidth}))},
             at);
      }
    }
    keep_apart(numbers);
    for (index_t i = first; i < last; ++i) join(static_cast<std::size_t>(i - lane0));
  }
  for (std::size_t k = 0; k < count; ++k) values[k] = join_lanes<Fold>(lanes[k].data());
}

}  // namespace physgen::detail
