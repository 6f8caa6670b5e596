// One record for all objects, which are all the same.
#pragma once

#include <physgen/layout/aos.h>

namespace physgen {

/// Every object is the first one.
struct UniformPitch {
  PHYSGEN_FUNCTION constexpr explicit UniformPitch(index_t /*same*/) {}
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr index_t value() { return 1; }
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr index_t tile(index_t /*i*/) { return 0; }
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr index_t lane(index_t /*i*/) { return 0; }
};

/// One record, whatever the index. For views that are read: stores of several objects would meet in it. An array has
/// this layout through UniformArray (scene_arrays.h), since untyped_array.h describes arrays with a record for each
/// object.
struct Uniform : Aos {
  using Pitch = UniformPitch;
  static constexpr const char* name = "uniform";
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr bool contiguous(int /*width*/) { return false; }
};

}  // namespace physgen
