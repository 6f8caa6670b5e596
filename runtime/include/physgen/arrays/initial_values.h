// The initial values of new objects, over arrays without their types.
#pragma once

#include <physgen/arrays/untyped_array.h>

namespace physgen {

/// Sets objects begin .. end-1, whose memory is zero as a new Buffer's is, to their fields' initial values.
/// @throw Error when a field's format cannot hold its initial value, unless that is zero
/// @pre 0 <= begin <= end <= array.padded
void initialize(const UntypedArray& array, index_t begin, index_t end);

/// The same for objects whose memory holds anything.
void reset(const UntypedArray& array, index_t begin, index_t end);

}  // namespace physgen
