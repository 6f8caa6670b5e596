// Kernels that keep a stream busy, or break the device, for host code.
#pragma once

#include <physgen/memory/space.h>

namespace physgen::test {

/// Keeps `stream` busy for some hundredths of a second: what does not wait for it comes first.
void spin(Stream stream);

/// Orders a kernel that traps: after it the process can use the device no more.
void trap(Stream stream);

}  // namespace physgen::test
