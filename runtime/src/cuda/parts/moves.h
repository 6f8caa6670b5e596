// A conversion in parts that are small enough for the parameters of a launch.
#pragma once

#include "../../convert.h"

namespace physgen::cuda {

inline constexpr int moves_per_launch = 64;
inline constexpr int rotations_per_launch = 16;

/// A part of a conversion, small enough for the parameters of a launch.
struct Moves {
  int elements = 0;
  int rotations = 0;
  detail::ElementMove element[moves_per_launch];
  detail::RotationMove rotation[rotations_per_launch];
};

/// Threads of a block whose kernel takes one object each.
inline constexpr int threads = 256;

[[nodiscard]] inline unsigned blocks_for(index_t objects, int block) {
  return static_cast<unsigned>((objects + block - 1) / block);
}

/// Calls launch(moves) with all moves of a conversion, in parts.
template <class Launch>
void for_each_part(const detail::Conversion& conversion, const Launch& launch) {
  std::size_t element = 0, rotation = 0;
  while (element < conversion.elements.size() || rotation < conversion.rotations.size()) {
    Moves moves;
    while (element < conversion.elements.size() && moves.elements < moves_per_launch) {
      moves.element[moves.elements++] = conversion.elements[element++];
    }
    while (rotation < conversion.rotations.size() && moves.rotations < rotations_per_launch) {
      moves.rotation[moves.rotations++] = conversion.rotations[rotation++];
    }
    launch(moves);
  }
}

}  // namespace physgen::cuda
