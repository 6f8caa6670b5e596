// How the entries of Galerkin sums are coded, for the kernels that form them and for the lists.
#pragma once

namespace physgen::fem {

/// What a Galerkin sum takes of one fine block, in elasticity::Incidence::local: the kind + 4 (quarters - 1).
enum class GalerkinBlock {
  node,     ///< K of a node
  edge,     ///< E of an edge
  reverse,  ///< E^T
};

}  // namespace physgen::fem
