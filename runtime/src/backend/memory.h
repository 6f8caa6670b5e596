// Memory of a backend: every header of this folder is implemented by a file of its name in cuda/, with a GPU, and by
// one in no_cuda/, without.
#pragma once

#include <physgen/memory/space.h>

#include <cstddef>
#include <string>

namespace physgen::backend {

/// Zeroed memory of the pinned or cuda space, or null with the reason in `why`.
[[nodiscard]] std::byte* allocate(SpaceKind space, index_t bytes, std::string& why);
void deallocate(SpaceKind space, std::byte* data) noexcept;

/// Plain copy of bytes where at least one side is in CUDA memory, ordered in `stream`.
void copy_bytes(std::byte* to, const std::byte* from, index_t bytes, Stream stream);

/// Copies `strips` strips of `bytes` bytes that lie `to_pitch` and `from_pitch` bytes apart, where at least one side is
/// in CUDA memory, ordered in `stream`.
void copy_strips(std::byte* to, index_t to_pitch, const std::byte* from, index_t from_pitch, index_t bytes, int strips,
                 Stream stream);

/// Waits for all work of the device.
void synchronize_device();

}  // namespace physgen::backend
