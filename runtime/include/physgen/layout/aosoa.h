// Array of structs of arrays: tiles of W objects, a struct of arrays inside each.
#pragma once

#include <physgen/layout/pitch.h>

namespace physgen {

/// Tiles of W objects, W a power of two. W = 32 is one warp on CUDA; a multiple of the pack width suits the CPU.
template <int W>
struct Aosoa {
  static_assert(W >= 2 && W <= 1024 && (W & (W - 1)) == 0, "the tile of an Aosoa is a power of two from 2 to 1024");
  using Pitch = StaticPitch<W>;
  static constexpr const char* name = "aosoa";
  static constexpr int tile = W;
  [[nodiscard]] static constexpr index_t pitch(index_t /*objects*/) { return W; }
  [[nodiscard]] static constexpr index_t padded(index_t objects) {
    return align_up(objects, W > padding_objects ? index_t{W} : padding_objects);
  }
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr int record_bytes(int bytes, int /*alignment*/) {
    return W < 8 ? align_up(bytes, 8 / W) : bytes;  // elements are 1 to 8 bytes: every tile begins at a multiple of 8
  }
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr bool contiguous(int width) { return W % width == 0; }
};

}  // namespace physgen
