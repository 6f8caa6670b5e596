// Sums at one element by several threads, of the host or of a device.
#pragma once

#include <physgen/config.h>

#include <atomic>

#if __has_include(<sys/single_threaded.h>)
#include <sys/single_threaded.h>
#endif

namespace physgen::detail {

/// Adds `value` to an element that several threads may add to. While a process has never had a second thread, the C
/// library says so, and it is a plain sum: the atomic one takes some 20 cycles.
template <class T>
PHYSGEN_FUNCTION inline void add_atomically(T& to, T value) {
#ifdef __CUDA_ARCH__
  atomicAdd(&to, value);
#else
#if __has_include(<sys/single_threaded.h>)
  if (__libc_single_threaded != 0) {
    to += value;
    return;
  }
#endif
  std::atomic_ref<T>(to).fetch_add(value, std::memory_order_relaxed);
#endif
}

}  // namespace physgen::detail
