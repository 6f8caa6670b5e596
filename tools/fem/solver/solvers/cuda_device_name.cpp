#include <fem/solver/solvers/solvers.h>
#include <physgen/cuda/check.h>

namespace physgen::fem {

std::string cuda_device_name() {
  int device = 0;
  cudaDeviceProp properties{};
  cuda::check(cudaGetDevice(&device), "asking for the current device");
  cuda::check(cudaGetDeviceProperties(&properties, device), "asking for its name");
  return properties.name;
}

}  // namespace physgen::fem
