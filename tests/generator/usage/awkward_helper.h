// A function in another file than the kernel that calls it.
#pragma once

#include <physgen/config.h>

namespace awkward {

template <class View>
PHYSGEN_FUNCTION void add_one(const View& view, physgen::index_t i) {
  view[i].volume() = float(view[i].volume()) + 1.0F;
}

}  // namespace awkward
