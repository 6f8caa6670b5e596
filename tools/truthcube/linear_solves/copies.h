// How long a device takes to copy bytes: what memory-bound kernels are held against.
#pragma once

#include <fem/solver/settings.h>
#include <physgen/config.h>

namespace physgen::truthcube {

/// Times a copy that reads and writes `bytes` together, half of them each. @return the median after a first [s]
/// @throw Error when the memory cannot be had, or the copy fails
[[nodiscard]] double seconds_of_copy(fem::Device device, index_t bytes);

}  // namespace physgen::truthcube
