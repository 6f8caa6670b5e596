// A build without CUDA has no arrays in CUDA memory whose topology could change.
#include "../backend/topology.h"

#include <physgen/error.h>

#include "parts/reason.h"

namespace physgen::backend {

void pick(const UntypedArray& /*to*/, index_t /*begin*/, const UntypedArray& /*from*/, detail::Picked /*picked*/,
          index_t /*count*/, Stream /*stream*/) {
  throw Error(reason);
}
index_t first_not_renumbered(const detail::Renumbering& /*renumbering*/, index_t /*size*/) { throw Error(reason); }
void renumber(const detail::Renumbering& /*renumbering*/, index_t /*size*/) { throw Error(reason); }

}  // namespace physgen::backend
