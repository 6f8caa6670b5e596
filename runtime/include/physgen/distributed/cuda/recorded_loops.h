// Loops over several ranks, recorded as graphs whose rounds the device decides on. Included by CUDA translation units
// only.
#pragma once

#include <physgen/distributed/partition.h>
#include <physgen/distributed/transport.h>
#include <physgen/memory/buffer.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace physgen::cuda {

/// What crosses in a round depends on which fields of ghosts are fresh before it, and a graph holds the addresses of
/// arrays. A round is recorded that leaves both as they were, and replayed where they are so.
struct RoundState {
  std::vector<HaloNeedBits> fresh;       ///< of each array and field: the needs of which ghosts have owners' values
  std::vector<HaloNeedBits> also;        ///< of each array and field: the needs for which it crosses, too
  std::vector<char> is_gathered;         ///< of each array and field
  std::vector<const std::byte*> memory;  ///< of each array, which a program may swap

  explicit RoundState(const Partition& arrays) {
    for (const DistributedArray& array : arrays.arrays()) {
      fresh.insert(fresh.end(), array.fresh.begin(), array.fresh.end());
      also.insert(also.end(), array.also.begin(), array.also.end());
      is_gathered.insert(is_gathered.end(), array.is_gathered.begin(), array.is_gathered.end());
      memory.push_back(array.untyped().base);
    }
  }
  bool operator==(const RoundState&) const = default;
};

/// The number of needs that steps have asked for, of all sets.
[[nodiscard]] inline std::size_t needs_of(const Partition& arrays) {
  std::size_t count = 0;
  for (const DistributedSet& set : arrays.sets()) count += set.needs.size();
  return count;
}

/// @tparam Loop of CudaExecutor
template <class Loop>
struct RecordedLoop {
  RoundState state;  ///< before a round, and behind it
  Loop loop = {};
  std::size_t counter = 0;  ///< of its rounds
};

/// What crosses in the rounds of a recorded loop, which the device counts.
struct CountedRounds {
  Traffic of_round;
  Buffer rounds{SpaceKind::pinned, sizeof(int), "the number of rounds of a loop"};
  int seen = 0;

  explicit CountedRounds(const Traffic& traffic) : of_round(traffic) { *number() = 0; }
  [[nodiscard]] int* number() { return reinterpret_cast<int*>(rounds.data()); }
  /// Of the rounds since the last call. @pre the device is done with them
  [[nodiscard]] Traffic take() {
    const int before = std::exchange(seen, *number());
    return of_round * (seen - before);
  }
};

}  // namespace physgen::cuda
