// A second stream beside a main one, for work that overlaps with transfers.
#pragma once

#include <physgen/config.h>
#include <physgen/cuda/check.h>

namespace physgen::cuda {

/// Steps k = 0, 1, ... of work; nothing is waited for at steps k < 0.
class SideStream {
 public:
  /// Begins after the work that is in `main` now.
  explicit SideStream(cudaStream_t main) : main_(main) {
    check(cudaStreamCreateWithFlags(&stream_, cudaStreamNonBlocking), "making a stream");
    for (cudaEvent_t* event : {&events_[0], &events_[1], &reached_}) {
      check(cudaEventCreateWithFlags(event, cudaEventDisableTiming), "making an event");
    }
    waits_for_main();
  }
  SideStream(const SideStream&) = delete;
  SideStream& operator=(const SideStream&) = delete;
  /// The main stream's next work, such as giving memory back, begins after all of the side's.
  ~SideStream() {
    cudaEventRecord(reached_, stream_);
    cudaStreamWaitEvent(main_, reached_, 0);
    for (cudaEvent_t event : {events_[0], events_[1], reached_}) cudaEventDestroy(event);
    cudaStreamDestroy(stream_);
  }
  [[nodiscard]] cudaStream_t stream() const { return stream_; }

  /// The side's next work begins after all that is in the main stream now.
  void waits_for_main() const {
    check(cudaEventRecord(reached_, main_), "noting a transfer");
    check(cudaStreamWaitEvent(stream_, reached_, 0), "ordering a conversion");
  }
  /// Notes that the side's step k is complete here.
  void done(index_t k) const { check(cudaEventRecord(events_[k % 2], stream_), "noting a conversion"); }
  /// The main stream's next work begins after the side's step k, or a later one.
  void main_waits_for(index_t k) const {
    if (k >= 0) check(cudaStreamWaitEvent(main_, events_[k % 2], 0), "ordering a transfer");
  }

 private:
  cudaStream_t main_;
  cudaStream_t stream_ = nullptr;
  cudaEvent_t events_[2] = {};
  cudaEvent_t reached_ = nullptr;
};

}  // namespace physgen::cuda
