// Timing on the GPU: events around one launch, and the device's own copy that kernels are compared with.
#pragma once

#include <physgen/buffer.h>
#include <physgen/storage.h>

#include "row.h"

struct CUevent_st;

namespace physgen::bench {

/// Two events on the default stream.
class DeviceStopwatch {
 public:
  DeviceStopwatch();
  DeviceStopwatch(const DeviceStopwatch&) = delete;
  DeviceStopwatch& operator=(const DeviceStopwatch&) = delete;
  ~DeviceStopwatch();
  void start();
  /// Waits for all since start(). @return its time [s] @throw Error when a kernel failed
  double stop();

 private:
  CUevent_st *start_ = nullptr, *stop_ = nullptr;
};

/// A case on the GPU, with the copy of the bytes its kernel moves.
class TimedCudaCase : public Case {
 public:
  /// @param bytes the kernel moves; the copy reads one half and writes the other
  explicit TimedCudaCase(double bytes);
  double copy() override;

  /// As poison() of errors.h, in device memory.
  static void poison_device(const Storage& storage);

 protected:
  DeviceStopwatch& watch() { return watch_; }

 private:
  DeviceStopwatch watch_;
  Buffer from_, to_;
};

}  // namespace physgen::bench
