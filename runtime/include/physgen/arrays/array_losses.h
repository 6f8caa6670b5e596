// Counts values that the storage formats of whole arrays could not hold: in the counters that checked builds keep
// behind the objects of an array, and before a copy.
#pragma once

#include <physgen/arrays/losses.h>
#include <physgen/arrays/untyped_array.h>

namespace physgen {

/// Counts the values of `from` that the formats of `to` could not hold, before a copy. On CUDA done when it returns.
/// @throw Error where their fields keep copy() from copying
/// @pre both describe the same object type; only the memory of `from` is read
[[nodiscard]] Losses losses_of_copy(const UntypedArray& to, const UntypedArray& from, Stream stream = nullptr);

/// @throw Error naming field, object and value where `losses` has falsified ones
void throw_if_falsified(const Losses& losses, const UntypedArray& array);

/// Reads counters, sets them to zero and tells them that the first `objects` objects count. Waits for all work of the
/// device.
[[nodiscard]] Losses take_losses(Losses& counters, index_t objects, SpaceKind space);

/// Sets up the counters of a new array: how many objects count, and what `old` has counted, unless it is null.
void start_losses(Losses& counters, const Losses* old, index_t objects, SpaceKind space);

namespace detail {

/// losses_of_copy() of objects begin .. end-1. @pre the fields do not keep copy() from copying
[[nodiscard]] Losses losses_of_range(const UntypedArray& to, const UntypedArray& from, index_t begin, index_t end,
                                     Stream stream);

}  // namespace detail

}  // namespace physgen
