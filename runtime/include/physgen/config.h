// What every header of the runtime needs: the function marker for host and device code, the index type, and the number
// that ties generated code to the runtime it was written for.
#pragma once

#include <cstddef>
#include <cstdint>

/// Changes when generated code must be regenerated; generated headers refuse to compile against another number.
#define PHYSGEN_RUNTIME_VERSION 3

// PHYSGEN_FUNCTION marks what runs on host and device. PHYSGEN_UNROLL stands before a loop with a constant trip count:
// values of a kernel must stay in registers, and a loop that is not unrolled indexes memory.
#if defined(__CUDACC__)
#define PHYSGEN_FUNCTION __host__ __device__
#else
#define PHYSGEN_FUNCTION
#endif
#if defined(__CUDA_ARCH__) || defined(__clang__)
#define PHYSGEN_UNROLL _Pragma("unroll")
#elif defined(__CUDACC__)
#define PHYSGEN_UNROLL  // nvcc's host pass knows neither spelling
#else
#define PHYSGEN_UNROLL _Pragma("GCC unroll 64")
#endif

namespace physgen {

/// Counts objects and bytes; signed, 64 bit: more than 2^31 objects are ordinary.
using index_t = std::int64_t;

/// Whether bounds, null, spaces and losses of storage formats are checked.
#ifdef PHYSGEN_CHECKED
inline constexpr bool checked_build = true;
#else
inline constexpr bool checked_build = false;
#endif

/// Smallest multiple of `step` that is not below `value`. @pre value >= 0, step > 0
template <class Integer>
[[nodiscard]] PHYSGEN_FUNCTION constexpr Integer align_up(Integer value, Integer step) {
  return (value + step - 1) / step * step;
}

}  // namespace physgen
