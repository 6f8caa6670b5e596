// The largest sizes that a model may state.
#pragma once

#include <bit>

namespace physgen::model {

/// Largest vector, matrix side, array extent and record of one object (in elements); they keep all offsets far inside
/// int.
inline constexpr int max_side = 1024;
inline constexpr int max_extent = 65536;
inline constexpr int max_elements = 1 << 20;
inline constexpr int max_tile = 1024;
inline constexpr int max_alignment = 256;

/// Whether `value` is a power of two from 1 to `limit`: the rule of tiles and alignments.
[[nodiscard]] constexpr bool is_power_of_two_up_to(int value, int limit) {
  return value >= 1 && value <= limit && std::has_single_bit(static_cast<unsigned>(value));
}

}  // namespace physgen::model
