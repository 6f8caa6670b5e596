// Memory of the CUDA backend, and plain copies.
#include <physgen/cuda/check.h>
#include <physgen/device.h>

#include <limits>

#include "../backend/memory.h"

namespace physgen::backend {

using cuda::check;

std::byte* allocate(SpaceKind space, index_t bytes, std::string& why) {
  detail::refuse_capture(nullptr, "an allocation");
  void* data = nullptr;
  const auto size = static_cast<std::size_t>(bytes);
  cudaError_t status = space == SpaceKind::cuda ? cudaMalloc(&data, size) : cudaMallocHost(&data, size);
  if (status == cudaSuccess) {
    status = cudaMemset(data, 0, size);
    if (status == cudaSuccess) status = cudaDeviceSynchronize();
    if (status != cudaSuccess) deallocate(space, static_cast<std::byte*>(data));
  }
  if (status == cudaSuccess) return static_cast<std::byte*>(data);
  cudaGetLastError();  // as check() does
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

void synchronize_device() {
  detail::refuse_capture(nullptr, "waiting for the device");
  check(cudaDeviceSynchronize(), "waiting for the device");
}

void copy_strips(std::byte* to, index_t to_pitch, const std::byte* from, index_t from_pitch, index_t bytes, int strips,
                 Stream stream) {
  // CUDA takes strips up to 2^31 - 1 bytes apart; so far apart, each is long enough to be a copy of its own.
  constexpr index_t longest_pitch = std::numeric_limits<std::int32_t>::max();
  if (strips == 1 || to_pitch > longest_pitch || from_pitch > longest_pitch) {
    for (index_t k = 0; k < strips; ++k) copy_bytes(to + k * to_pitch, from + k * from_pitch, bytes, stream);
    return;
  }
  check(cudaMemcpy2DAsync(to, static_cast<std::size_t>(to_pitch), from, static_cast<std::size_t>(from_pitch),
                          static_cast<std::size_t>(bytes), static_cast<std::size_t>(strips), cudaMemcpyDefault, stream),
        "copying between spaces");
}

}  // namespace physgen::backend
