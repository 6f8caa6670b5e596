// Conversions between arrays that host code can reach.
#pragma once

#include <physgen/arrays/losses.h>
#include <physgen/arrays/untyped_array.h>

namespace physgen::detail {

/// Object i of `to` becomes object i of `from` for i = begin .. end-1, on all threads.
/// @param to_first, from_first number of the object at the beginning of the array: 0, or more for a part of one
void convert_on_host(const UntypedArray& to, index_t to_first, const UntypedArray& from, index_t from_first,
                     index_t begin, index_t end);

/// Sets memory to zero, on all threads.
void clear_on_host(std::byte* memory, index_t bytes);

/// Counts the values of objects begin .. end-1 that the formats of `to` could not hold. @pre host code can reach `from`
[[nodiscard]] Losses count_on_host(const UntypedArray& to, const UntypedArray& from, index_t begin, index_t end);

}  // namespace physgen::detail
