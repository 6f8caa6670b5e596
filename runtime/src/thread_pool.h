// The threads of launches, oneTBB's.
#pragma once

#include <tbb/task_arena.h>

namespace physgen::detail {

/// Where launches run on threads() threads. It lives as long as the process.
/// @return null where one thread does all
[[nodiscard]] tbb::task_arena* arena_of_launches();

}  // namespace physgen::detail
