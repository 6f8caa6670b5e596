// Copies between arrays that store the same records: bytes move in as few runs as the layouts allow.
#pragma once

#include <physgen/arrays/untyped_array.h>

namespace physgen::detail {

/// Whether both store every element in the same type at the same place of the record.
[[nodiscard]] bool same_records(const UntypedArray& a, const UntypedArray& b);

/// Whether in both the same objects lie side by side: the tiles are the same, or each array is one tile.
[[nodiscard]] bool same_runs(const UntypedArray& a, const UntypedArray& b);

/// Objects from_begin .. from_begin + count - 1 of `from` become those from to_begin on of `to`. On the host done when
/// this returns, else ordered in `stream`. Whole tiles are one run, part of a tile is one per element of a record.
/// @return bytes moved
/// @pre same_records(); the objects lie inside the memory (padding included) of both, and do not overlap
index_t copy_plain(const UntypedArray& to, index_t to_begin, const UntypedArray& from, index_t from_begin,
                   index_t count, Stream stream);

}  // namespace physgen::detail
