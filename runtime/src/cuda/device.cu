// The device and its streams, with CUDA.
#include <physgen/cuda/check.h>
#include <physgen/device.h>

namespace physgen {

using cuda::check;

void detail::refuse_capture(Stream stream, const char* what) {
  if (stream == nullptr && !cuda_available()) return;
  cudaStreamCaptureStatus status = cudaStreamCaptureStatusNone;
  const cudaError_t error = cudaStreamIsCapturing(stream, &status);
  if (error == cudaErrorStreamCaptureImplicit) {
    cudaGetLastError();
    status = cudaStreamCaptureStatusActive;
  } else {
    check(error, what);
  }
  if (status == cudaStreamCaptureStatusNone) return;
  throw Error(std::string(what) + " must wait or allocate, which cannot be captured in a graph: " +
              (stream == nullptr ? "a stream that waits for the default stream, in which this works," : "its stream") +
              " is being captured; do it before cudaStreamBeginCapture() or after cudaStreamEndCapture()");
}

void synchronize(Stream stream) {
  if (stream == nullptr && !cuda_available()) return;  // nothing can have been ordered
  detail::refuse_capture(stream, "waiting for a stream");
  check(cudaStreamSynchronize(stream), "waiting for a stream");
}

// Asked once: on a device whose context a kernel has broken CUDA may deny that there is one, and work would seem done.
bool cuda_available() {
  static const bool available = [] {
    int devices = 0;
    const bool found = cudaGetDeviceCount(&devices) == cudaSuccess && devices > 0;
    if (!found) cudaGetLastError();
    return found;
  }();
  return available;
}

}  // namespace physgen
