// How much a process has at once of what it writes.
#pragma once

#include <cstddef>

namespace physgen::truthcube {

/// Bytes that a process has at once of a state that it prints and writes, beside what the mesh and the solver have:
/// such a state goes by windows, whatever the size of the mesh.
inline constexpr std::size_t window_bytes = std::size_t{64} << 20;

}  // namespace physgen::truthcube
