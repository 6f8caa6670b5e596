// Adds to one element from several threads, on the host or on a device.
#pragma once

#include <physgen/config.h>

#include <atomic>
#include <type_traits>

#if __has_include(<sys/single_threaded.h>)
#include <sys/single_threaded.h>
#endif

namespace physgen::detail {

/// Adds `value` to an element that several threads may add to. While a process has never had a second thread, the C
/// library says so, and it is a plain sum: the atomic one takes some 20 cycles.
template <class T>
PHYSGEN_FUNCTION inline void add_atomically(T& to, T value) {
#ifdef __CUDA_ARCH__
  if constexpr (std::is_integral_v<T> &&
                sizeof(T) == 8) {  // of 64 bits CUDA has the sum of unsigned ones, which wraps alike
    atomicAdd(reinterpret_cast<unsigned long long*>(&to), static_cast<unsigned long long>(value));
  } else {
    atomicAdd(&to, value);
  }
#else
#if __has_include(<sys/single_threaded.h>)
  if (__libc_single_threaded != 0) {
    if constexpr (std::is_integral_v<T>) {  // wraps, as the atomic sum does
      using Bits = std::make_unsigned_t<T>;
      to = static_cast<T>(static_cast<Bits>(static_cast<Bits>(to) + static_cast<Bits>(value)));
    } else {
      to += value;
    }
    return;
  }
#endif
  std::atomic_ref<T>(to).fetch_add(value, std::memory_order_relaxed);
#endif
}

}  // namespace physgen::detail
