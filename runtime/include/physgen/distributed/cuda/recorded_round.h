// A round of a loop over several ranks, recorded as a graph. Included by CUDA translation units only.
#pragma once

#include <physgen/cuda/check.h>
#include <physgen/distributed/partition.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace physgen::cuda {

/// What crosses in a round depends on which fields of ghosts are fresh before it, and a graph holds the addresses of
/// arrays. A round is recorded that leaves both as they were, and replayed where they are so.
class RecordedRound {
 public:
  RecordedRound() = default;
  RecordedRound(RecordedRound&& other) noexcept { swap(other); }
  RecordedRound& operator=(RecordedRound&& other) noexcept {
    swap(other);
    return *this;
  }
  RecordedRound(const RecordedRound&) = delete;
  RecordedRound& operator=(const RecordedRound&) = delete;
  ~RecordedRound() {
    if (graph_ != nullptr) cudaGraphExecDestroy(graph_);
  }

  struct State {
    std::vector<HaloNeedBits> fresh;       ///< of each array and field: the needs of which ghosts have owners' values
    std::vector<HaloNeedBits> also;        ///< of each array and field: the needs for which it crosses, too
    std::vector<char> is_gathered;         ///< of each array and field
    std::vector<const std::byte*> memory;  ///< of each array, which a program may swap
    bool operator==(const State&) const = default;
  };
  [[nodiscard]] static State state_of(const Partition& arrays) {
    State state;
    for (const DistributedArray& array : arrays.arrays()) {
      state.fresh.insert(state.fresh.end(), array.fresh.begin(), array.fresh.end());
      state.also.insert(state.also.end(), array.also.begin(), array.also.end());
      state.is_gathered.insert(state.is_gathered.end(), array.is_gathered.begin(), array.is_gathered.end());
      state.memory.push_back(array.untyped().base);
    }
    return state;
  }

  /// The number of needs that steps have asked for, of all sets.
  [[nodiscard]] static std::size_t needs_of(const Partition& arrays) {
    std::size_t count = 0;
    for (const DistributedSet& set : arrays.sets()) count += set.needs.size();
    return count;
  }

  [[nodiscard]] bool fits(const State& state) const { return graph_ != nullptr && state_ == state; }

  /// Records what round() orders in `stream`, and runs nothing.
  /// @pre a round that began as this one does has been run: it connected ranks and took all memory that it needs
  /// @throw Error when a step waits or allocates, which a graph cannot hold
  template <class Round>
  void record(Stream stream, const Partition& arrays, Transport& transport, const Round& round) {
    state_ = state_of(arrays);
    const Traffic before = transport.traffic();
    cudaGraph_t graph = nullptr;
    check(cudaStreamBeginCapture(stream, cudaStreamCaptureModeThreadLocal), "recording a loop");
    try {
      round();
    } catch (...) {
      cudaStreamEndCapture(stream, &graph);
      if (graph != nullptr) cudaGraphDestroy(graph);
      throw;
    }
    check(cudaStreamEndCapture(stream, &graph), "recording a loop");
    const cudaError_t status = cudaGraphInstantiate(&graph_, graph, 0);
    cudaGraphDestroy(graph);
    check(status, "recording a loop");
    traffic_ = transport.traffic() - before;
    transport.count(Traffic{} - traffic_);  // nothing has crossed yet
  }
  void replay(Stream stream, Transport& transport) const {
    check(cudaGraphLaunch(graph_, stream), "launching a loop");
    transport.count(traffic_);
  }

 private:
  void swap(RecordedRound& other) noexcept {
    std::swap(graph_, other.graph_);
    std::swap(state_, other.state_);
    std::swap(traffic_, other.traffic_);
  }

  cudaGraphExec_t graph_ = nullptr;
  State state_;      ///< before it
  Traffic traffic_;  ///< of a round
};

}  // namespace physgen::cuda
