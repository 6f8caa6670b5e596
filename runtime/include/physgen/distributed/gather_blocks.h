// The values of all ranks' blocks in the order of one process.
#pragma once

#include <physgen/distributed/runs.h>
#include <physgen/distributed/transport.h>

#include <cstddef>
#include <span>
#include <vector>

namespace physgen {

/// @param mine of this rank's blocks, entry by entry, each of value_bytes
/// @return the same of all blocks, on every rank
[[nodiscard]] std::vector<std::byte> gather_blocks(Transport& transport, const Runs& runs,
                                                   std::span<const std::byte> mine, int entries,
                                                   std::size_t value_bytes);

}  // namespace physgen
