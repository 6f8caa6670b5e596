// Events, the device's copy, poison in device memory, and what the device is.
#include "measure/cuda.h"

#include <cuda_runtime_api.h>
#include <physgen/cuda/check.h>
#include <physgen/device.h>
#include <physgen/memory/buffer.h>

#include <memory>

#include "measure/registry.h"

namespace physgen::bench {

namespace {

/// Two events on the default stream.
struct Events {
  cudaEvent_t start = nullptr, stop = nullptr;
  Events() {
    cuda::check(cudaEventCreate(&start), "creating an event");
    cuda::check(cudaEventCreate(&stop), "creating an event");
  }
};
const Events& events() {
  static const Events made;  // until the program ends
  return made;
}

DeviceFacts facts() {
  DeviceFacts found;
  cudaDeviceProp properties{};
  int runtime = 0, driver = 0;
  if (!cuda_available()) {
    found.missing = "no usable CUDA device: rows of the GPU are left out";
  } else if (cudaGetDeviceProperties(&properties, 0) != cudaSuccess || cudaRuntimeGetVersion(&runtime) != cudaSuccess ||
             cudaDriverGetVersion(&driver) != cudaSuccess) {
    found.missing = "the CUDA device does not answer: rows of the GPU are left out";
  } else {
    const auto version = [](int number) {
      return std::to_string(number / 1000) + "." + std::to_string(number % 1000 / 10);
    };
    found.name = std::string(properties.name) + ", " + std::to_string(properties.multiProcessorCount) +
                 " multiprocessors, CUDA " + version(runtime) + ", driver for CUDA " + version(driver);
    found.memory = static_cast<double>(properties.totalGlobalMem);
    found.cache = properties.l2CacheSize;
  }
  return found;
}
[[maybe_unused]] const bool registered = add_device(facts);

}  // namespace

void CudaDevice::start() { cuda::check(cudaEventRecord(events().start), "starting a measurement"); }

double CudaDevice::stop() {
  cuda::check(cudaEventRecord(events().stop), "ending a measurement");
  cuda::check(cudaEventSynchronize(events().stop), "waiting for a kernel");
  float milliseconds = 0;
  cuda::check(cudaEventElapsedTime(&milliseconds, events().start, events().stop), "reading a time");
  return static_cast<double>(milliseconds) * 1e-3;
}

std::function<double()> CudaDevice::copy(double bytes) {
  const auto half = static_cast<index_t>(bytes / 2);
  const auto from = std::make_shared<Buffer>(SpaceKind::cuda, half, "the source of the copy");
  const auto to = std::make_shared<Buffer>(SpaceKind::cuda, half, "the target of the copy");
  return [from, to] {
    return time([&] {
      cuda::check(
          cudaMemcpyAsync(to->data(), from->data(), static_cast<std::size_t>(from->bytes()), cudaMemcpyDeviceToDevice),
          "copying on the device");
    });
  };
}

void CudaDevice::poison(const UntypedArray& array) {
  cuda::check(cudaMemset(array.base, 0xff, static_cast<std::size_t>(array.bytes())), "poisoning an output");
}

}  // namespace physgen::bench
