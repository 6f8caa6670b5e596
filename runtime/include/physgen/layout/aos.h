// Array of structs: one record after the other.
#pragma once

#include <physgen/layout/pitch.h>

namespace physgen {

/// Array of structs with natural alignment of the record.
struct Aos {
  using Pitch = StaticPitch<1>;
  static constexpr const char* name = "aos";
  /// Objects between the starts of two elements that follow each other in a record.
  [[nodiscard]] static constexpr index_t pitch(index_t /*objects*/) { return 1; }
  /// Objects for which memory is held.
  [[nodiscard]] static constexpr index_t padded(index_t objects) { return align_up(objects, padding_objects); }
  /// Bytes of one record in an array of this layout.
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr int record_bytes(int bytes, int alignment) {
    return align_up(bytes, alignment);
  }
  /// Whether `width` consecutive objects from a multiple of `width` on lie side by side.
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr bool contiguous(int width) { return width == 1; }
};

}  // namespace physgen
