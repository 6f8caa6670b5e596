// The basis of every header of the runtime: the function marker for host and device code, the index type, the number
// that ties generated code to the runtime it was written for, and the constant that ties objects to the library of
// their mode.
#pragma once

#if __cplusplus <= 201703L
#error "physgen needs C++20 (g++: -std=c++20, nvcc: -std=c++20); in CMake, link physgen::runtime, which gives it"
#endif

#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "physgen needs NaN and infinity: leave -ffast-math and -Ofast, or add -fno-finite-math-only"
#endif

#include <cstddef>
#include <cstdint>

/// Changes when generated code must be regenerated; generated headers refuse to compile against another number.
#define PHYSGEN_RUNTIME_VERSION 7

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

// Checked objects and others disagree about arrays and views and must not meet in one program. So each refers to a
// constant that the library of its own mode defines and no other; where a program has the wrong library, the linker
// names that constant. PHYSGEN_ANY_MODE is for those sources of physgen that both libraries contain as they are: they
// have no checked_build to ask for.
#ifdef PHYSGEN_CHECKED
extern "C" const char physgen_objects_were_compiled_with_PHYSGEN_CHECKED;
/// Whether bounds, null, spaces and losses of storage formats are checked.
inline constexpr bool checked_build = true;
namespace detail {
[[gnu::used, gnu::visibility("hidden")]] inline const char* const checked_mode =
    &physgen_objects_were_compiled_with_PHYSGEN_CHECKED;
}
#elif !defined(PHYSGEN_ANY_MODE)
extern "C" const char physgen_objects_were_compiled_without_PHYSGEN_CHECKED;
inline constexpr bool checked_build = false;
namespace detail {
[[gnu::used, gnu::visibility("hidden")]] inline const char* const unchecked_mode =
    &physgen_objects_were_compiled_without_PHYSGEN_CHECKED;
}
#endif

/// Smallest multiple of `step` that is not below `value`. @pre value >= 0, step > 0
template <class Integer>
[[nodiscard]] PHYSGEN_FUNCTION constexpr Integer align_up(Integer value, Integer step) {
  return (value + step - 1) / step * step;
}

}  // namespace physgen
