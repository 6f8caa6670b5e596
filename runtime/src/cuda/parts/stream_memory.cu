// See stream_memory.h.
#include <physgen/cuda/check.h>
#include <physgen/device.h>

#include <map>
#include <mutex>

#include "stream_memory.h"

namespace physgen::cuda {

namespace {

// The pool of the current device. Never destroyed: CUDA may be gone before static objects are.
cudaMemPool_t pool() {
  static auto* const pools = new std::map<int, cudaMemPool_t>();
  static std::mutex mutex;
  int device = 0;
  check(cudaGetDevice(&device), "asking for the current device");
  const std::lock_guard lock(mutex);
  const auto found = pools->find(device);
  if (found != pools->end()) return found->second;
  cudaMemPoolProps properties = {};
  properties.allocType = cudaMemAllocationTypePinned;
  properties.location.type = cudaMemLocationTypeDevice;
  properties.location.id = device;
  cudaMemPool_t made = nullptr;
  check(cudaMemPoolCreate(&made, &properties), "making a pool of device memory");
  std::uint64_t kept = std::uint64_t{128} << 20;
  check(cudaMemPoolSetAttribute(made, cudaMemPoolAttrReleaseThreshold, &kept), "making a pool of device memory");
  return pools->emplace(device, made).first->second;
}

}  // namespace

StreamMemory::StreamMemory(index_t bytes, cudaStream_t stream) : stream_(stream) {
  detail::refuse_capture(stream, "an operation that needs memory of its own");
  check(cudaMallocFromPoolAsync(&data_, static_cast<std::size_t>(bytes), pool(), stream),
        "allocating device memory for the time of an operation");
}

}  // namespace physgen::cuda
