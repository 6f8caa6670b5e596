// Shapes of tets at rest, on the host, for solvers over any executor.
#pragma once

#include <elasticity.physgen.h>
#include <fem/solver/hierarchy/hierarchy.h>

namespace physgen::fem {

/// Corners of the tets of a level.
[[nodiscard]] elasticity::TetArray<double> host_tets(const MeshLevel& level);
/// Dm^-1 and volume of each tet.
[[nodiscard]] elasticity::RestShapeArray<double> host_rest_shapes(const MeshLevel& level);

}  // namespace physgen::fem
