// Places in lists of std::vector, which the numbers of nodes, tets and edges are.
#pragma once

#include <physgen/config.h>

#include <cstddef>

namespace physgen::fem {

inline std::size_t at(index_t i) { return static_cast<std::size_t>(i); }

}  // namespace physgen::fem
