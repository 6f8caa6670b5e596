// Events, the device's copy, and poison in device memory.
#include <physgen/cuda/check.h>

#include "cuda_timing.h"

namespace physgen::bench {

DeviceStopwatch::DeviceStopwatch() {
  cuda::check(cudaEventCreate(&start_), "creating an event");
  cuda::check(cudaEventCreate(&stop_), "creating an event");
}

DeviceStopwatch::~DeviceStopwatch() {
  cudaEventDestroy(start_);
  cudaEventDestroy(stop_);
}

void DeviceStopwatch::start() { cuda::check(cudaEventRecord(start_), "starting a measurement"); }

double DeviceStopwatch::stop() {
  cuda::check(cudaEventRecord(stop_), "ending a measurement");
  cuda::check(cudaEventSynchronize(stop_), "waiting for a kernel");
  float milliseconds = 0;
  cuda::check(cudaEventElapsedTime(&milliseconds, start_, stop_), "reading a time");
  return static_cast<double>(milliseconds) * 1e-3;
}

TimedCudaCase::TimedCudaCase(double bytes)
    : from_(SpaceKind::cuda, static_cast<index_t>(bytes / 2), "the source of the copy"),
      to_(SpaceKind::cuda, static_cast<index_t>(bytes / 2), "the target of the copy") {}

double TimedCudaCase::copy() {
  watch_.start();
  cuda::check(
      cudaMemcpyAsync(to_.data(), from_.data(), static_cast<std::size_t>(from_.bytes()), cudaMemcpyDeviceToDevice),
      "copying on the device");
  return watch_.stop();
}

void TimedCudaCase::poison_device(const Storage& storage) {
  cuda::check(cudaMemset(storage.base, 0xff, static_cast<std::size_t>(storage.bytes())), "poisoning an output");
}

}  // namespace physgen::bench
