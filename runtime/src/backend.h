// What a memory backend does for the runtime. Implemented once per folder: cuda/ with a GPU, no_cuda/ without.
#pragma once

#include <physgen/untyped_array.h>

#include <string>

#include "convert.h"

namespace physgen::backend {

/// Zeroed memory of the pinned or cuda space, or null with the reason in `why`.
[[nodiscard]] std::byte* allocate(SpaceKind space, index_t bytes, std::string& why);
void deallocate(SpaceKind space, std::byte* data) noexcept;

/// Plain copy of bytes where at least one side is in CUDA memory, ordered in `stream`.
void copy_bytes(std::byte* to, const std::byte* from, index_t bytes, Stream stream);

/// Copies `rows` rows of `bytes` bytes that lie `to_pitch` and `from_pitch` bytes apart, where at least one side is in
/// CUDA memory, ordered in `stream`.
void copy_rows(std::byte* to, index_t to_pitch, const std::byte* from, index_t from_pitch, index_t bytes, int rows,
               Stream stream);

/// Converts objects begin .. end-1 where at least one side is in CUDA memory, and both only where no functions of the
/// program's own change a field; see cuda/transfer.cu for what travels and
/// where it is converted.
/// @return bytes that travelled between host and device; between arrays of the device, those of the objects read
index_t convert(const UntypedArray& to, const UntypedArray& from, index_t begin, index_t end, Stream stream);

/// Sets one field of objects begin .. end-1 in CUDA memory to its initial value; done when this returns.
void fill(const UntypedArray& array, const detail::Fill& field, index_t begin, index_t end);

/// What the formats of `to` could not hold of objects begin .. end-1 of `from`, which lies in CUDA memory; done when
/// this returns.
[[nodiscard]] Losses count_losses(const UntypedArray& to, const UntypedArray& from, index_t begin, index_t end,
                                  Stream stream);

/// Waits for all work of the device.
void synchronize_device();

}  // namespace physgen::backend
