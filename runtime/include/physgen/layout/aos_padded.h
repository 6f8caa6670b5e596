// Array of structs whose records are multiples of 16 bytes, so that a record is read in 16-byte loads (float4 nodes).
#pragma once

#include <physgen/layout/aos.h>

namespace physgen {

/// Array of structs, each record padded to a multiple of 16 bytes. For objects that are gathered by index.
struct AosPadded : Aos {
  static constexpr const char* name = "aos_padded";
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr int record_bytes(int bytes, int alignment) {
    return align_up(bytes, alignment < 16 ? 16 : alignment);
  }
};

}  // namespace physgen
