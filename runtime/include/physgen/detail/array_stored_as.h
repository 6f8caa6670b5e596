// The array that WithFormats of scenes/scene_arrays.h names.
#pragma once

#include <physgen/arrays/array.h>

namespace physgen::detail {

template <class Of, class Formats>
struct ArrayStoredAs {
  using type = Array<typename Of::Object, typename Of::Precision, typename Of::Space, typename Of::Layout, Formats>;
};

}  // namespace physgen::detail
