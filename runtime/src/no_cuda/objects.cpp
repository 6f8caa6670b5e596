// A build without CUDA has no objects in CUDA memory.
#include "../backend/objects.h"

#include <physgen/error.h>

#include "parts/reason.h"

namespace physgen::backend {

void fill(const UntypedArray& /*array*/, const detail::Fill& /*field*/, index_t /*begin*/, index_t /*end*/) {
  throw Error(reason);
}

Losses count_losses(const UntypedArray& /*to*/, const UntypedArray& /*from*/, index_t /*begin*/, index_t /*end*/,
                    Stream /*stream*/) {
  throw Error(reason);
}

}  // namespace physgen::backend
