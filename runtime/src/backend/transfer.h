// Copies that convert where an array lies in CUDA memory. The same files implement physgen/arrays/chunked_transfer.h.
#pragma once

#include <physgen/arrays/untyped_array.h>

namespace physgen::backend {

/// Converts objects begin .. end-1 where at least one side is in CUDA memory, and both only where no functions of the
/// program's own change a field. cuda/transfer.cu says what travels and where it is converted.
/// @return bytes that travelled between host and device; between arrays of the device, those of the objects read
index_t convert(const UntypedArray& to, const UntypedArray& from, index_t begin, index_t end, Stream stream);

}  // namespace physgen::backend
