// Codes the entries of Galerkin sums, for the kernels that form them and for the lists.
#pragma once

#include <physgen/config.h>

namespace physgen::fem {

/// The part of one fine block that a Galerkin sum takes, times 1/4, 1/2 or 1.
enum class GalerkinBlock {
  node,     ///< K of a node; between nested meshes times 1/4
  edge,     ///< E of an edge
  reverse,  ///< E^T
};

/// In IncidenceEntry::local: 0 for a node; 1, 2, 3 for 1, 2 and 4 quarters of an edge's block; 4, 5, 6 of its
/// transpose.
[[nodiscard]] constexpr int galerkin_code(GalerkinBlock block, int quarters) {
  if (block == GalerkinBlock::node) return 0;
  return (block == GalerkinBlock::edge ? 1 : 4) + quarters / 2;
}
[[nodiscard]] PHYSGEN_FUNCTION constexpr GalerkinBlock galerkin_block(int code) {
  return code == 0 ? GalerkinBlock::node : (code < 4 ? GalerkinBlock::edge : GalerkinBlock::reverse);
}
/// Quarters of the block.
[[nodiscard]] PHYSGEN_FUNCTION constexpr int galerkin_quarters(int code) {
  return code == 0 ? 1 : 1 << ((code - 1) % 3);
}

}  // namespace physgen::fem
