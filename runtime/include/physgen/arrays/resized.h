// An array of another size that is to take the place of one, for loading: the old one stays as it is until then.
#pragma once

#include <physgen/arrays/array.h>

#include <algorithm>

namespace physgen::detail {

/// An array of `size` objects: the first min(old, new) have the values of `array`, and the others initial ones. It has
/// the losses that `array` has counted.
template <class Array>
[[nodiscard]] Array resized(const Array& array, index_t size) {
  Array other(size);
  copy_range(other.untyped(), array.untyped(), 0, std::min(size, array.size()));
  other.inherit_losses(array);
  return other;
}

}  // namespace physgen::detail
