// Numbers that objects name.
#pragma once

#include <physgen/distributed/partition.h>
#include <physgen/error.h>

#include <string>

namespace physgen::detail {

/// @throw Error when the number names no object
inline void require_object(const DistributedSet& set, index_t number, index_t by) {
  if (number >= -1 && number < set.size) return;
  throw Error("object " + std::to_string(by) + " names object " + std::to_string(number) + " of set " + set.name +
              ", which has " + std::to_string(set.size) + "; name one of 0 .. size-1, or -1 for none");
}

}  // namespace physgen::detail
