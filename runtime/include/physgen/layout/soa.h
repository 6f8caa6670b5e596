// Struct of arrays with one constant pitch for all channels: never a walk over earlier fields.
#pragma once

#include <physgen/layout/pitch.h>

namespace physgen {

/// Struct of arrays: each element of a record is a channel; channel starts are `pitch` elements apart.
struct Soa {
  using Pitch = WholePitch;
  static constexpr const char* name = "soa";
  /// A pitch of whole pages would put all channels of an object into one set of a cache, so such a pitch grows by
  /// padding_objects: one to four lines.
  [[nodiscard]] static constexpr index_t padded(index_t objects) {
    const index_t whole = align_up(objects, padding_objects);
    return whole > 0 && whole % 512 == 0 ? whole + padding_objects : whole;
  }
  [[nodiscard]] static constexpr index_t pitch(index_t objects) { return padded(objects); }
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr int record_bytes(int bytes, int /*alignment*/) { return bytes; }
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr bool contiguous(int /*width*/) { return true; }
};

}  // namespace physgen
