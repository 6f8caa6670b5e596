// A build without CUDA has no lists in CUDA memory.
#include <physgen/detail/device_lists.h>
#include <physgen/error.h>

#include "parts/reason.h"

namespace physgen::detail {

index_t scan(const NumberList& /*numbers*/, Stream /*stream*/) { throw Error(backend::reason); }
void sort(const NumberList& /*keys*/, const ValueList& /*values*/, Stream /*stream*/) { throw Error(backend::reason); }

}  // namespace physgen::detail
