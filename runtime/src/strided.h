// Elements of consecutive objects as loops of the host run along them: evenly spaced, whatever the layout.
#pragma once

#include <algorithm>
#include <limits>

#include "addressing.h"

namespace physgen::detail {

/// Elements of consecutive objects, `stride` bytes apart.
struct StridedElements {
  std::byte* first;
  index_t stride;
};

[[nodiscard]] inline StridedElements strided(const Addressing& array, index_t i, int offset, int size) {
  return {array.address(i, offset, size), array.records() ? array.record_bytes : size};
}

/// Objects from i on whose elements are evenly spaced.
[[nodiscard]] inline index_t evenly_spaced(const Addressing& array, index_t i) {
  if (array.records() || array.shift == 63) return std::numeric_limits<index_t>::max();
  return array.pitch - array.lane(i);
}

}  // namespace physgen::detail
