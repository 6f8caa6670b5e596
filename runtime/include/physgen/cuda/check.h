// Turns CUDA's error codes into physgen::Error.
#pragma once

#include <cuda_runtime_api.h>
#include <physgen/error.h>

#include <string>

namespace physgen::cuda {

/// @throw Error naming what was asked and CUDA's message, when `status` is not success
inline void check(cudaError_t status, const char* asked) {
  if (status != cudaSuccess) {
    cudaGetLastError();  // reported here, and must not be seen again by the next check
    throw Error(std::string(asked) + ": " + cudaGetErrorName(status) + ": " + cudaGetErrorString(status));
  }
}

}  // namespace physgen::cuda
