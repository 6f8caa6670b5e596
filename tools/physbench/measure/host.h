// The CPU as a device of rows: wall clock around one run, and the copy that kernels are compared with.
#pragma once

#include <physgen/parallel_for.h>

#include <chrono>
#include <functional>

#include "measure/errors.h"

namespace physgen::bench {

/// A device of rows is of this form.
struct HostDevice {
  using Space = Host;

  /// The time of work() [s].
  template <class Work>
  static double time(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  template <int kLanes, class Kernel>
  static void run(index_t objects, const Kernel& kernel) {
    parallel_for(Host{}, objects, lanes<kLanes>(kernel));
  }
  /// A copy of half of `bytes`: memcpy, by all threads. @return what gives its time [s]
  static std::function<double()> copy(double bytes);
  static void poison(const UntypedArray& array) { bench::poison(array); }
};

}  // namespace physgen::bench
