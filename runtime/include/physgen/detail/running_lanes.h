// Which lanes the kernel that runs on this thread was called for. Host translation units alone include it.
#pragma once

#include <physgen/kernels/pack.h>

namespace physgen::detail {

/// The lanes, of an index as wide as W, that the kernel which runs on this thread was called for: gathered indices do
/// not know them, and stores through these leave the others alone. All, outside of kernels and in whole packs of builds
/// that are not checked.
struct RunningLanes {
  LaneRange range;
  int width;

  [[nodiscard]] LaneRange of(int W) const { return W == width ? range : LaneRange{0, W}; }
};
inline thread_local RunningLanes running_lanes{{0, 0}, 0};

/// Sets them until it goes out of scope.
class RunLanes {
 public:
  explicit RunLanes(const RunningLanes& lanes) : before_(running_lanes) { running_lanes = lanes; }
  RunLanes(const RunLanes&) = delete;
  RunLanes& operator=(const RunLanes&) = delete;
  ~RunLanes() { running_lanes = before_; }

 private:
  RunningLanes before_;
};

}  // namespace physgen::detail
