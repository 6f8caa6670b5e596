// Device memory for the duration of work in a stream.
#pragma once

#include <physgen/config.h>
#include <physgen/cuda/check.h>

namespace physgen::cuda {

class StreamMemory {
 public:
  StreamMemory(index_t bytes, cudaStream_t stream) : stream_(stream) {
    check(cudaMallocAsync(&data_, static_cast<std::size_t>(bytes), stream),
          "allocating device memory for a conversion");
  }
  StreamMemory(const StreamMemory&) = delete;
  StreamMemory& operator=(const StreamMemory&) = delete;
  ~StreamMemory() { cudaFreeAsync(data_, stream_); }
  [[nodiscard]] std::byte* data() const { return static_cast<std::byte*>(data_); }

 private:
  void* data_ = nullptr;
  cudaStream_t stream_;
};

}  // namespace physgen::cuda
