// Device memory for the duration of work in a stream.
#pragma once

#include <cuda_runtime_api.h>
#include <physgen/config.h>

namespace physgen::cuda {

/// Memory of a pool, which keeps up to 128 MiB per device for the next time: mapping memory for each copy takes
/// longer than to convert its objects.
class StreamMemory {
 public:
  /// @throw Error when the memory cannot be had, or the stream is being captured
  StreamMemory(index_t bytes, cudaStream_t stream);
  StreamMemory(const StreamMemory&) = delete;
  StreamMemory& operator=(const StreamMemory&) = delete;
  ~StreamMemory() { cudaFreeAsync(data_, stream_); }
  [[nodiscard]] std::byte* data() const { return static_cast<std::byte*>(data_); }

 private:
  void* data_ = nullptr;
  cudaStream_t stream_;
};

}  // namespace physgen::cuda
