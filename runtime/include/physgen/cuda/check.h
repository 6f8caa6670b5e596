// Turns CUDA's error codes into physgen::Error.
#pragma once

#include <cuda_runtime_api.h>
#include <physgen/error.h>

#include <string>

namespace physgen::cuda {

/// Whether every later call fails as well, since a kernel has broken the process's context.
[[nodiscard]] inline bool is_lasting(cudaError_t status) {
  switch (status) {
    case cudaErrorIllegalAddress:
    case cudaErrorLaunchTimeout:
    case cudaErrorAssert:
    case cudaErrorHardwareStackError:
    case cudaErrorIllegalInstruction:
    case cudaErrorMisalignedAddress:
    case cudaErrorInvalidAddressSpace:
    case cudaErrorInvalidPc:
    case cudaErrorLaunchFailure:
      return true;
    default:
      return false;
  }
}

/// @throw Error naming what was asked and CUDA's message, when `status` is not success
inline void check(cudaError_t status, const char* asked) {
  if (status != cudaSuccess) {
    cudaGetLastError();  // reported here, and must not be seen again by the next check
    throw Error(std::string(asked) + ": " + cudaGetErrorName(status) + ": " + cudaGetErrorString(status) +
                (is_lasting(status) ? "; a kernel has failed, and this process can use the device no more" : ""));
  }
}

}  // namespace physgen::cuda
