// Objects in CUDA memory: their initial values, and counts of values that formats cannot hold.
#pragma once

#include <physgen/arrays/losses.h>

#include "../convert.h"

namespace physgen::backend {

/// Sets one field of objects begin .. end-1 in CUDA memory to its initial value; done when this returns.
void fill(const UntypedArray& array, const detail::Fill& field, index_t begin, index_t end);

/// Counts the values of objects begin .. end-1 of `from`, which lies in CUDA memory, that the formats of `to` could not
/// hold; done when this returns.
[[nodiscard]] Losses count_losses(const UntypedArray& to, const UntypedArray& from, index_t begin, index_t end,
                                  Stream stream);

}  // namespace physgen::backend
