// Changes of topology in CUDA memory. See memory.h for who implements it.
#pragma once

#include "../move_objects.h"

namespace physgen::backend {

/// Object begin + i of `to` becomes object picked[i] of `from`, i = 0 .. count-1, as plain bytes, ordered in `stream`.
/// @pre both store the same records in CUDA memory; the picked numbers lie there too
void pick(const UntypedArray& to, index_t begin, const UntypedArray& from, detail::Picked picked, index_t count,
          Stream stream);

/// The first of the objects 0 .. size-1 with an index that cannot be renumbered, or size. Waits.
/// @pre array and numbers lie in CUDA memory
[[nodiscard]] index_t first_not_renumbered(const detail::Renumbering& renumbering, index_t size);

/// Renumbers the objects 0 .. size-1; done when this returns.
/// @pre first_not_renumbered() found none
void renumber(const detail::Renumbering& renumbering, index_t size);

}  // namespace physgen::backend
