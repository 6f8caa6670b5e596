// Conversions on the device that change the layout alone: the records' elements are all of one size and stay as they
// are.
#pragma once

#include <physgen/arrays/untyped_array.h>

namespace physgen::cuda {

/// Converts whole blocks of objects from `begin` on, as convert() of device_convert.h does, where both arrays store the
/// same records of up to 16 elements of 4 or 8 bytes without padding.
/// @return the first object that it has not converted: begin, where it cannot do anything; the rest is convert()'s
[[nodiscard]] index_t transpose(const UntypedArray& to, index_t to_first, const UntypedArray& from, index_t from_first,
                                index_t begin, index_t end, Stream stream);

}  // namespace physgen::cuda
