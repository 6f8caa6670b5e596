// SIMD access on the CPU: a view under a Pack or a PartialPack stands on W objects side by side, under a batch of
// integers on W objects gathered by index, and hands out xsimd batches. parallel_for.h includes this; a kernel that is
// run by other means does. For host translation units only.
#pragma once

#include <physgen/detail/simd_gather.h>
#include <physgen/detail/simd_packs.h>
