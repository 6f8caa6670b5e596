// Conversions between arrays in CUDA memory.
#pragma once

#include <physgen/arrays/untyped_array.h>

namespace physgen::cuda {

/// Object i of `to` becomes object i of `from` for i = begin .. end-1, ordered in `stream`.
/// @param to_first, from_first number of the object that lies at the beginning of the array: 0, or more for a part
/// @pre to_first and from_first are multiples of 32
void convert(const UntypedArray& to, index_t to_first, const UntypedArray& from, index_t from_first, index_t begin,
             index_t end, Stream stream);

}  // namespace physgen::cuda
