// A round of a loop over several ranks, recorded as a graph. Included by CUDA translation units only.
#pragma once

#include <physgen/cuda/check.h>
#include <physgen/distributed/partition.h>

#include <utility>
#include <vector>

namespace physgen::cuda {

/// What crosses in a round depends on which fields of ghosts are fresh before it. A round is recorded that leaves them
/// fresh as they were, and replayed where they are so.
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

  /// Of each array and field, whether ghosts have their owners' values.
  using Freshness = std::vector<char>;
  [[nodiscard]] static Freshness freshness_of(const Partition& arrays) {
    Freshness all;
    for (const DistributedArray& array : arrays.arrays()) {
      all.insert(all.end(), array.is_fresh.begin(), array.is_fresh.end());
    }
    return all;
  }

  [[nodiscard]] bool is_recorded() const { return graph_ != nullptr; }
  [[nodiscard]] bool fits(const Freshness& freshness) const { return is_recorded() && freshness_ == freshness; }

  /// Records what round() orders in `stream`, and runs nothing.
  /// @pre a round that began as this one does has been run: it connected ranks and took all memory that it needs
  /// @throw Error when a step waits or allocates, which a graph cannot hold
  template <class Round>
  void record(Stream stream, const Partition& arrays, Transport& transport, const Round& round) {
    freshness_ = freshness_of(arrays);
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
    std::swap(freshness_, other.freshness_);
    std::swap(traffic_, other.traffic_);
  }

  cudaGraphExec_t graph_ = nullptr;
  Freshness freshness_;
  Traffic traffic_;  ///< of a round
};

}  // namespace physgen::cuda
