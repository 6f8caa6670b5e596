// Copies of objects between arrays without their types, which convert whatever differs: layout, storage format,
// precision and space. In which order they and other work happen is the rule of streams (device.h).
#pragma once

#include <physgen/arrays/untyped_array.h>

namespace physgen {

/// Copies all objects of `from` to `to`, which comes first wherever the library copies. Where both lie on the host,
/// pinned or not, or one lies in host memory that is not pinned, it is done when this returns; else only ordered in
/// `stream`. A field that `to` prunes is left out.
/// @throw Error when the sizes or the object types differ, an array is null, or they share memory; when `from` does not
/// store a field that `to` has, or `to` stores nothing of one without pruning it (format/nothing.h); in checked builds
/// also when a format cannot hold a value (losses_of_copy() of array_losses.h falsifies one). `to` is then unchanged
void copy(const UntypedArray& to, const UntypedArray& from, Stream stream = nullptr);

/// Copies objects begin .. end-1 only, to the same numbers, as copy() does; the sizes may differ. Between spaces only
/// these objects are transferred.
/// @return bytes of the objects as they were transferred
/// @throw Error as copy(), and when there are no such objects in both arrays; `to` is then unchanged
index_t copy_range(const UntypedArray& to, const UntypedArray& from, index_t begin, index_t end,
                   Stream stream = nullptr);

}  // namespace physgen
