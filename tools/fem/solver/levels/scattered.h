// Numbers that look random, from the number of an object: the same on every device and for any number of threads.
#pragma once

#include <physgen/config.h>

#include <cstdint>

namespace physgen::fem::detail {

/// @return in [-1, 1)
PHYSGEN_FUNCTION inline double scattered(index_t number, int seed) {
  auto bits = (static_cast<std::uint32_t>(number) + 0x9e3779b9U * static_cast<std::uint32_t>(seed)) * 2654435769U;
  bits ^= bits >> 15U;
  bits *= 2246822519U;
  bits ^= bits >> 13U;
  return static_cast<double>(bits) / 2147483648.0 - 1;
}

}  // namespace physgen::fem::detail
