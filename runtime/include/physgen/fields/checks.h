// The check of inner indices: entries of fixed arrays, elements of vectors and matrices. In builds that are not checked
// it is nothing.
#pragma once

#include <physgen/config.h>

#ifdef PHYSGEN_CHECKED
#include <physgen/error.h>

#include <cstdio>
#include <string>
#endif

namespace physgen {

/// Refuses an index that is not in 0 .. count-1: with an Error on the host, a message and a trap on the device.
/// @param what it is an index of, such as "an entry of md::Rows::j"
#ifdef PHYSGEN_CHECKED
PHYSGEN_FUNCTION inline void check_inner(int index, int count, const char* what) {
  if (index >= 0 && index < count) return;
#ifdef __CUDA_ARCH__
  printf("physgen: index %d of %s, of which there are %d (on the device)\n", index, what, count);
  __trap();
#else
  throw Error("index " + std::to_string(index) + " of " + what + ", of which there are " + std::to_string(count) +
              "; give one from 0 to " + std::to_string(count - 1));
#endif
}
#else
PHYSGEN_FUNCTION constexpr void check_inner([[maybe_unused]] int index, [[maybe_unused]] int count,
                                            [[maybe_unused]] const char* what) {}
#endif

}  // namespace physgen
