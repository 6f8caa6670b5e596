// What a memory backend does for the runtime. Implemented once per folder: cuda/ with a GPU, no_cuda/ without.
#pragma once

#include <physgen/storage.h>

#include <string>

namespace physgen::backend {

/// Zeroed memory of the pinned or cuda space, or null with the reason in `why`.
[[nodiscard]] std::byte* allocate(SpaceKind space, index_t bytes, std::string& why);
void deallocate(SpaceKind space, std::byte* data) noexcept;

/// Plain copy of bytes where at least one side is in CUDA memory, ordered in `stream`.
void copy_bytes(std::byte* to, const std::byte* from, index_t bytes, Stream stream);

/// Converts objects begin .. end-1 where at least one side is in CUDA memory. Done on the device: what lies on the host
/// is transferred in its own layout.
void convert(const Storage& to, const Storage& from, index_t begin, index_t end, Stream stream);

/// Sets one field of objects begin .. end-1 in CUDA memory to its initial value; done when this returns.
void fill(const Storage& storage, const FieldInfo& field, index_t begin, index_t end);

}  // namespace physgen::backend
