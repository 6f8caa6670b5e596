// Timing on the CPU: wall clock around one run, and the copy that kernels are compared with.
#pragma once

#include <physgen/buffer.h>

#include <chrono>

#include "row.h"

namespace physgen::bench {

class Stopwatch {
 public:
  [[nodiscard]] double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

/// A case on the CPU, with the copy of the bytes its kernel moves: memcpy, one piece per OpenMP thread.
class TimedHostCase : public Case {
 public:
  /// @param bytes the kernel moves; the copy reads one half and writes the other
  explicit TimedHostCase(double bytes);
  double copy() override;

 private:
  Buffer from_, to_;
};

}  // namespace physgen::bench
