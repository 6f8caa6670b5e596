// Changes of topology in a build without CUDA: there is no array that could ask for them.
#include <physgen/error.h>

#include "../backend_topology.h"
#include "reason.h"

namespace physgen::backend {

void pick(const Storage& /*to*/, index_t /*begin*/, const Storage& /*from*/, detail::Picked /*picked*/,
          index_t /*count*/, Stream /*stream*/) {
  throw Error(reason);
}
index_t first_not_renumbered(const Storage& /*storage*/, const FieldInfo& /*field*/,
                             const detail::NewNumbers& /*numbers*/) {
  throw Error(reason);
}
void renumber(const Storage& /*storage*/, const FieldInfo& /*field*/, const detail::NewNumbers& /*numbers*/) {
  throw Error(reason);
}

}  // namespace physgen::backend
