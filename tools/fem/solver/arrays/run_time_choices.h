// The choices that programs of the solver offer at run time: the rest is not compiled, and fields that it alone would
// need are pruned.
#pragma once

namespace physgen::fem {

struct AnyChoice {
  static constexpr bool assembled = true;    ///< a stiffness that is assembled, and multigrid
  static constexpr bool matrix_free = true;  ///< products by tets
  static constexpr bool grids = true;        ///< levels of a background grid
};
/// An assembled stiffness.
struct AssembledAnywhere {
  static constexpr bool assembled = true, matrix_free = false, grids = true;
};
/// The same, and levels of meshes alone.
struct AssembledOnMeshes {
  static constexpr bool assembled = true, matrix_free = false, grids = false;
};
/// Products by tets.
struct ByTets {
  static constexpr bool assembled = false, matrix_free = true, grids = false;
};

}  // namespace physgen::fem
