// The GPU as a device of rows: events around one run, and the device's own copy that kernels are compared with.
#pragma once

#include <physgen/arrays/untyped_array.h>

#include <functional>

namespace physgen::bench {

/// As HostDevice. How it runs kernels, measure/cuda_rows.h adds for CUDA files.
struct CudaDevice {
  using Space = Cuda;

  template <class Work>
  static double time(const Work& work) {
    start();
    work();
    return stop();
  }
  static std::function<double()> copy(double bytes);
  static void poison(const UntypedArray& array);

  /// A measurement in the default stream; one at a time.
  static void start();
  /// Waits for all since start(). @return its time [s] @throw Error when a kernel failed
  static double stop();
};

}  // namespace physgen::bench
