// Refuses numbers of objects that do not fit 32 bits.
#pragma once

#include <physgen/config.h>

#include <cstdint>
#include <limits>

#ifndef __CUDA_ARCH__
#include <physgen/error.h>

#include <string>
#else
#include <cstdio>
#endif

namespace physgen::detail {

/// @throw Error when `last`, an object's number, is not a 32-bit number; on the device a message and a trap
PHYSGEN_FUNCTION inline void check_number(index_t last) {
  if (last <= std::numeric_limits<std::int32_t>::max()) return;
#ifdef __CUDA_ARCH__
  printf("physgen: numbers(i) of object %lld is above 2147483647; run on parts of the array, or on single objects\n",
         static_cast<long long>(last));
  __trap();
#else
  throw Error("numbers(i) of object " + std::to_string(last) +
              ": it gives 32-bit numbers, up to 2147483647; run the kernel over parts of the array, or on single "
              "objects, whose index is 64-bit");
#endif
}

}  // namespace physgen::detail
