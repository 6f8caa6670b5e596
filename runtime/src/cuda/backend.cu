// The CUDA backend: memory, transfers, and conversions on the device.
#include <physgen/cuda/check.h>

#include <algorithm>

#include "../backend.h"
#include "../convert.h"

namespace physgen {

namespace {

using cuda::check;

constexpr int fields_per_launch = 32;

struct Conversions {
  int count;
  detail::FieldConversion fields[fields_per_launch];
};

__global__ void convert_kernel(detail::Addressing to, detail::Addressing from, Conversions conversions, index_t begin,
                               index_t end) {
  const index_t i = begin + blockIdx.x * index_t{blockDim.x} + threadIdx.x;
  if (i >= end) return;
  for (int f = 0; f < conversions.count; ++f) detail::convert_field(to, from, conversions.fields[f], i);
}

__global__ void fill_kernel(detail::Addressing address, int offset, ElementType type, int count, double value,
                            index_t begin, index_t end) {
  const index_t i = begin + blockIdx.x * index_t{blockDim.x} + threadIdx.x;
  if (i < end) detail::fill_field(address, offset, type, count, value, i);
}

constexpr int block = 256;

[[nodiscard]] unsigned blocks_for(index_t objects) { return static_cast<unsigned>((objects + block - 1) / block); }

void convert_on_device(const Storage& to, const Storage& from, index_t begin, index_t end, cudaStream_t stream) {
  for (std::size_t first = 0; first < to.fields.size(); first += fields_per_launch) {
    Conversions conversions{};
    conversions.count = static_cast<int>(std::min<std::size_t>(fields_per_launch, to.fields.size() - first));
    for (int f = 0; f < conversions.count; ++f) {
      const FieldInfo& a = to.fields[first + static_cast<std::size_t>(f)];
      const FieldInfo& b = from.fields[first + static_cast<std::size_t>(f)];
      conversions.fields[f] = {a.offset, b.offset, a.type, b.type, a.count};
    }
    convert_kernel<<<blocks_for(end - begin), block, 0, stream>>>(detail::Addressing(to), detail::Addressing(from),
                                                                  conversions, begin, end);
    check(cudaGetLastError(), "launching a conversion");
  }
}

// Device memory for the duration of work in a stream.
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

}  // namespace

namespace backend {

std::byte* allocate(SpaceKind space, index_t bytes, std::string& why) {
  void* data = nullptr;
  const auto size = static_cast<std::size_t>(bytes);
  cudaError_t status = space == SpaceKind::cuda ? cudaMalloc(&data, size) : cudaMallocHost(&data, size);
  if (status == cudaSuccess) {
    status = cudaMemset(data, 0, size);
    if (status == cudaSuccess) status = cudaDeviceSynchronize();
    if (status != cudaSuccess) deallocate(space, static_cast<std::byte*>(data));
  }
  if (status == cudaSuccess) return static_cast<std::byte*>(data);
  cudaGetLastError();  // an allocation that failed is reported here and must not be seen again by the next check
  why = std::string(cudaGetErrorName(status)) + ": " + cudaGetErrorString(status);
  return nullptr;
}

void deallocate(SpaceKind space, std::byte* data) noexcept {
  if (space == SpaceKind::cuda) {
    cudaFree(data);
  } else {
    cudaFreeHost(data);
  }
}

void copy_bytes(std::byte* to, const std::byte* from, index_t bytes, Stream stream) {
  check(cudaMemcpyAsync(to, from, static_cast<std::size_t>(bytes), cudaMemcpyDefault, stream),
        "copying between spaces");
}

void convert(const Storage& to, const Storage& from, index_t begin, index_t end, Stream stream) {
  // A side on the host is represented on the device by a copy of its bytes; the target, too, since objects outside
  // begin .. end-1 and padding must stay as they are.
  if (from.space != SpaceKind::cuda) {
    const StreamMemory memory(from.bytes(), stream);
    copy_bytes(memory.data(), from.base, from.bytes(), stream);
    Storage on_device = from;
    on_device.base = memory.data();
    convert_on_device(to, on_device, begin, end, stream);
  } else if (to.space != SpaceKind::cuda) {
    const StreamMemory memory(to.bytes(), stream);
    copy_bytes(memory.data(), to.base, to.bytes(), stream);
    Storage on_device = to;
    on_device.base = memory.data();
    convert_on_device(on_device, from, begin, end, stream);
    copy_bytes(to.base, memory.data(), to.bytes(), stream);
  } else {
    convert_on_device(to, from, begin, end, stream);
  }
}

void fill(const Storage& storage, const FieldInfo& field, index_t begin, index_t end) {
  fill_kernel<<<blocks_for(end - begin), block>>>(detail::Addressing(storage), field.offset, field.type, field.count,
                                                  field.initial, begin, end);
  check(cudaGetLastError(), "launching the fill of an array");
  check(cudaDeviceSynchronize(), "filling an array");
}

}  // namespace backend

void synchronize(Stream stream) {
  if (stream == nullptr && !cuda_available()) return;  // nothing can have been ordered
  check(cudaStreamSynchronize(stream), "waiting for a stream");
}

bool cuda_available() {
  int devices = 0;
  const bool available = cudaGetDeviceCount(&devices) == cudaSuccess && devices > 0;
  if (!available) cudaGetLastError();
  return available;
}

}  // namespace physgen
