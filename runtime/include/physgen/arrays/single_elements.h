// Single elements of arrays without their types, by number, as doubles: for setting up, looking and testing.
#pragma once

#include <physgen/arrays/untyped_array.h>

namespace physgen {

/// Element k (counted over the fields in order, 9 for a rotation) of object i, converted to double and back. On CUDA a
/// transfer each.
/// @throw Error when i or k is out of range, or nothing is stored of the field; putdata also for an element of a
/// rotation stored as a quaternion, for a value that is not an index where one is stored, and in checked builds for one
/// that the format cannot hold
[[nodiscard]] double getdata(const UntypedArray& array, index_t i, int k);
void putdata(const UntypedArray& array, index_t i, int k, double value);

}  // namespace physgen
